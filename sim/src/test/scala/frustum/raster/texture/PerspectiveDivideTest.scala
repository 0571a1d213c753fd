package frustum.raster.texture

import frustum.contract.arithmetic.ReciprocalTable
import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim, Simulated}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class PerspectiveDivideTest extends AnyFunSuite {
  private def units(v: Double): String = f"2^${scala.math.log(v) / scala.math.log(2)}%.2f"

  test("r of every fraction is within 0.85 units of 2^-16, at the very end of the range within 1") {
    val worst = (0 until (1 << 20)).iterator.map { x =>
      val f = x / 1048576.0
      (ReciprocalTable(x) - 65536 * 2 * f / (1 + f)).abs / (if (x >= (255 << 12)) 1.25 else 1.0)
    }.max
    assert(worst <= 0.85, s"error of r: $worst units")
  }

  test("quotient against exact arithmetic: relative error below 2^-16, cutting below 2^-17 repeats") {
    val random = new Random(1)
    var relative = 0.0
    for (_ <- 0 until 300000) {
      val q = (1 << 30 | random.nextInt(1 << 30)) >> random.nextInt(15)
      val repeats = (random.nextDouble() * 2 - 1) * 256 / (1 << random.nextInt(9))
      val s = (repeats * (q / 256.0)).toInt
      val exact = BigDecimal(s) * 256 / BigDecimal(q)
      val error = ((BigDecimal(model.raster.texture.PerspectiveDivide(s, q)) / 131072) - exact).abs.toDouble
      relative = relative.max((error - 1.05 / 131072) / exact.abs.toDouble.max(1e-9))
      assert(error <= exact.abs.toDouble / 65536 + 1.05 / 131072, s"$s / $q: off by ${units(error)} repeats")
    }
    info(s"largest relative error beyond cutting: ${units(relative)}")
  }

  test("a power of two as q is exact down to the last fraction bit") {
    for (e <- 0 to 15; s <- Seq(0, 1, -1, 12345, -54321, (1 << 22) + 64)) {
      val q = 1 << (30 - e)
      val scaled = s >> e << 6 >> 6
      assert(model.raster.texture.PerspectiveDivide(scaled, q) == (scaled << e) >> 5, s"$scaled / 2^-$e")
    }
  }

  test("hardware equals model", Simulated) {
    val random = new Random(2)
    val corners = Seq(
      0,
      1,
      -1,
      Int.MaxValue,
      Int.MinValue,
      1 << 30,
      0x3fffffff,
      1 << 15,
      0xffff,
      1 << 16,
      1 << 27,
      1 << 26
    )
    val inputs = (for (q <- corners; s <- corners) yield (s, -s, q)) ++
      Seq.fill(5000)(
        (random.nextInt() >> random.nextInt(20), random.nextInt(), random.nextInt() >>> random.nextInt(20))
      )
    val expected = inputs.map { case (s, t, q) =>
      (model.raster.texture.PerspectiveDivide(s, q), model.raster.texture.PerspectiveDivide(t, q))
    }
    Equality(FrustumSim.compile("PerspectiveDivide")(PerspectiveDivide(Tech.Generic)))(_.io.up, _.io.down)(
      (p: ProjectiveCoordinate, v: (Int, Int, Int)) => { p.s #= v._1; p.t #= v._2; p.q #= v._3 },
      (c: TextureCoordinate) => (c.s.toInt, c.t.toInt)
    ).run(inputs, expected, seed = 2, minThroughput = Some(0.99))
  }
}
