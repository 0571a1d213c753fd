package frustum.raster.texture

import frustum.contract.raster.{
  Combine,
  DepthFunction,
  FixedState,
  PlaneFormats,
  RasterConfig,
  RenderState,
  TexelFormat,
  TextureRef,
  VertexRanges
}
import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim, Simulated}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class LateDivideTest extends AnyFunSuite {
  private def config(repeats: Int, ratio: Int, coordinate: Int) =
    RasterConfig(ranges = VertexRanges(repeats = repeats, ratio = ratio), formats = PlaneFormats(coordinate))

  private val configs = Seq(config(1, 1, 4), config(7, 3, 0), config(0, 2, 12), config(3, 1, 0), config(7, 1, 20))

  for (c <- configs) {
    val name = s"${c.ranges}, ${c.formats}"

    test(s"$name: quotient against exact arithmetic") {
      val random = new Random(1)
      val divide = new model.raster.texture.LateDivide(c)
      val low = LateDivide.low(c)
      for (_ <- 0 until 100000) {
        val q = (1 << 30 | random.nextInt(1 << 30)) >> random.nextInt(c.ranges.ratio + 1)
        val repeats = (random.nextDouble() * 2 - 1) * (1 << c.ranges.repeats)
        val s = (repeats * (q / 256.0)).toInt >> low << low
        val exact = BigDecimal(s) * 256 / BigDecimal(q)
        val error = (BigDecimal(divide(s, q)) / 131072 - exact).abs.toDouble
        val cut = (1.05 / 131072).max(scala.math.pow(2, low + divide.exponent(q) - 24)) + 1.0 / 131072
        assert(error <= exact.abs.toDouble / 65536 + cut, s"$s / $q: off by $error repeats")
      }
    }

    test(s"$name: hardware equals model", Simulated) {
      val random = new Random(2)
      val corners =
        Seq(0, 1, -1, Int.MaxValue, Int.MinValue, 1 << 30, 0x3fffffff, 1 << 29, 1 << 28, 0x1fffffff, 1 << 24, 1 << 16)
      val inputs = (for (q <- corners; s <- corners) yield (s, -s, q)) ++ Seq.fill(4000)(
        (random.nextInt() >> random.nextInt(20), random.nextInt(), random.nextInt() >>> random.nextInt(5))
      )
      val made = inputs.map { case (s, t, q) => (c.ranges.wrap(s), c.ranges.wrap(t), q) }
      val divide = new model.raster.texture.LateDivide(c)
      val expected = made.map { case (s, t, q) => (divide(s, q), divide(t, q)) }
      Equality(FrustumSim.compile("LateDivide")(LateDivide(c, Tech.Generic)))(_.io.up, _.io.down)(
        (p: ProjectiveCoordinate, v: (Int, Int, Int)) => { p.s #= v._1; p.t #= v._2; p.q #= v._3 },
        (t: TextureCoordinate) => (t.s.toInt, t.t.toInt)
      ).run(made, expected, seed = 2, minThroughput = Some(0.99))
    }
  }

  test("it is for triangles whose depths are near each other, where unwanted planes leave it its memories") {
    val texture = Some(TextureRef(0, 5, 5, TexelFormat.Rgb565))
    val replace = RenderState(texture, combine = Combine.Replace)
    val flat = replace.copy(depth = DepthFunction.Always)
    def made(ratio: Int, states: RenderState*) =
      RasterConfig(ranges = VertexRanges(ratio = ratio), fixed = FixedState.of(states: _*))
    for (c <- Seq(made(3, flat), made(1, replace), made(3, flat, flat.copy(blend = true)))) {
      assert(LateDivide.suits(c), c.fixed.planes)
      assert(model.raster.texture.Divide.of(c).isInstanceOf[model.raster.texture.LateDivide])
    }
    val modulated = replace.copy(combine = Combine.Modulate)
    for (c <- Seq(RasterConfig(), made(4, flat), made(1, modulated), made(1, replace, modulated), config(1, 1, 4))) {
      assert(!LateDivide.suits(c), c.fixed.planes)
      assert(model.raster.texture.Divide.of(c) eq model.raster.texture.PerspectiveDivide)
    }
  }
}
