package frustum.raster.fragment

import frustum.contract.raster.{RasterConfig, RenderState}
import frustum.harness.{Equality, FrustumSim, Simulated}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.Bits
import spinal.core.sim._

import scala.util.Random

class BlendTest extends AnyFunSuite {
  test("the model is exact at both ends of alpha and between equal colours, and nearest elsewhere") {
    for (source <- 0 until 64; target <- 0 until 64; a <- 0 until 32) {
      val w = a + (a >> 4)
      val exact = (source * w + target * (32 - w)) / 32.0
      val got = model.raster.fragment.Blend.channel(source, target, a)
      assert((got - exact).abs <= 0.5)
      if (a == 0) assert(got == target)
      if (a == 31) assert(got == source)
      if (source == target) assert(got == source)
    }
  }

  private val config = RasterConfig(19, 21, 3, 3)
  private val words = config.tileWidth * config.tileHeight
  private lazy val unit = FrustumSim.compile("Blend")(new BlendBench(config))
  private val seed = 6
  private case class Item(at: Int, color: Int, a: Int, passed: Boolean, end: Boolean)

  /** The next place, not among the last ones: the interlock keeps fragments of a pixel as many clocks apart. */
  private def places(r: Random, of: Int, apart: Int, count: Int): Seq[Int] =
    Iterator.iterate(Vector(0)) { last =>
      last.takeRight(apart - 1) :+ Iterator.continually(r.nextInt(of)).find(!last.takeRight(apart - 1).contains(_)).get
    }.map(_.last).take(count).toSeq

  private def color(r: Random): Int = Seq(0, 0xffff, r.nextInt(65536))(r.nextInt(3))

  for (blend <- Seq(false, true); clear <- Seq(0, 0xa5b7))
    test(f"tiles ${if (blend) "blended" else "replaced"} over $clear%04x", Simulated) {
      val r = new Random(seed)
      val apart = if (blend) 3 else 2
      val tiles = Seq(4, words, 5, words, 4).map(of => places(r, of, apart, 350 + r.nextInt(100)))
      val items = tiles.map(_.map(at =>
        Item(at, color(r), Seq(0, 31, r.nextInt(32))(r.nextInt(3)), r.nextInt(4) > 0, end = false)
      ))
      val expected = items.flatMap { tile =>
        val buffer = Array.fill(words)(clear)
        for (i <- tile if i.passed)
          buffer(i.at) = if (blend) model.raster.fragment.Blend(i.color, buffer(i.at), i.a) else i.color
        buffer
      }
      // Marks are never blended away, whatever their alpha.
      val inputs =
        items.flatMap(_ :+ Item(r.nextInt(words), color(r), r.nextInt(32), passed = r.nextBoolean(), end = true))
      Equality(unit)(_.io.up, _.io.down)(
        (p: BlendFragment, in: Item) => {
          p.at #= in.at; p.color #= in.color; p.a #= in.a; p.passed #= in.passed; p.tileEnd #= in.end
        },
        (p: Bits) => p.toInt
      ).run(
        inputs,
        expected,
        seed,
        minThroughput = Some(0.9), // the last tile's words come after all fragments
        setup = dut => { StateSim.drive(dut.io.state, RenderState(blend = blend)); dut.io.clearColor #= clear }
      )
    }
}
