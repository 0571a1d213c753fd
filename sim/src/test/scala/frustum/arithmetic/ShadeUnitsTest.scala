package frustum.arithmetic

import frustum.contract.arithmetic.FunctionTable
import frustum.device.Tech
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._

import scala.math.sqrt
import scala.util.Random

// Several units in one model: compiling a model takes longer than simulating it here.

private class FunctionUnits(tables: Seq[FunctionTable]) extends Component {
  val io = new Bundle { val x = in UInt (16 bits); val y = out(Vec(tables.map(_ => UInt(16 bits)))) }
  for ((table, y) <- tables.zip(io.y)) {
    val unit = FunctionUnit(table, Tech.Generic)
    unit.io.x := io.x
    y := unit.io.y
  }
}

private class WideMultipliers(widths: Seq[Int]) extends Component {
  val io = new Bundle {
    val a = in SInt (widths.max bits)
    val b = in UInt (16 bits)
    val product = out(Vec(widths.map(_ => SInt(widths.max + 16 bits))))
  }
  for ((width, product) <- widths.zip(io.product)) {
    val unit = WideMultiplier(Tech.Generic, width)
    unit.io.a := io.a.resized
    unit.io.b := io.b
    product := unit.io.product.resized
  }
}

private class MemoryDelays(delays: Seq[Int]) extends Component {
  val io = new Bundle { val a = in Bits (5 bits); val b = out(Vec(delays.map(_ => Bits(5 bits)))) }
  for ((clocks, b) <- delays.zip(io.b)) b := MemoryDelay(io.a, clocks)
}

/** The units that shading is made of, against whole numbers and the functions they stand for. */
class ShadeUnitsTest extends AnyFunSuite {
  private val root = new FunctionTable(rises = true, x => 65535 * sqrt(x.max(1.0 / 65536)))
  private val inverse = new FunctionTable(rises = false, x => 65535 / (1 + x))

  private val functions = Seq("rises" -> root, "falls" -> inverse)
  private lazy val functionUnits = FrustumSim.compile("FunctionUnits")(new FunctionUnits(functions.map(_._2)))

  for (((name, table), i) <- functions.zipWithIndex)
    test(s"a function that $name: every input", Simulated) {
      functionUnits.doSim(name, 1) { dut =>
        dut.clockDomain.forkStimulus(10)
        dut.io.x #= 0
        dut.clockDomain.waitSampling(10)
        for (x <- 0 until 65536 + FunctionUnit.Latency) {
          dut.io.x #= x.min(65535)
          dut.clockDomain.waitSampling()
          val of = x - FunctionUnit.Latency
          if (of >= 0) assert(dut.io.y(i).toInt == table(of), s"x = $of")
        }
      }
    }

  test("a table's error is a line's and a unit of rounding, from the second interval on") {
    for (x <- 256 until 65536) {
      val t = (x + 0.5) / 65536
      val bound =
        1 + 65535 * scala.math.pow(1.0 / 256, 2) / 8 * scala.math.pow(t - 1.0 / 256, -1.5).min(4096) / 4 + 1
      assert((root(x) - 65535 * sqrt(t)).abs <= bound, s"root of $x")
      assert((inverse(x) - 65535 / (1 + t)).abs <= 2.5, s"reciprocal of $x")
    }
  }

  private val widths = Seq(9, 16, 17, 27, 31)
  private lazy val multipliers = FrustumSim.compile("WideMultipliers")(new WideMultipliers(widths))

  for ((width, i) <- widths.zipWithIndex) test(s"wide product, a of $width bits", Simulated) {
    val random = new Random(width)
    val most = (1L << width - 1) - 1
    val corners = for (a <- Seq(-most - 1, -1L, 0L, 1L, most); b <- Seq(0, 1, 0x8000, 0xffff)) yield (a, b)
    val pairs = corners ++ Seq.fill(500)((random.between(-most - 1, most + 1), random.nextInt(65536)))
    multipliers.doSim(s"pairs$width", 1) { dut =>
      dut.clockDomain.forkStimulus(10)
      for ((a, b) <- pairs) {
        dut.io.a #= a
        dut.io.b #= b
        dut.clockDomain.waitSampling(Multiplier16.Latency + 1)
        assert(dut.io.product(i).toLong == a * b, s"$a * $b")
      }
    }
  }

  private val delays = Seq(2, 3, 7, 8, 20)
  private lazy val memoryDelays = FrustumSim.compile("MemoryDelays")(new MemoryDelays(delays))

  for ((clocks, unit) <- delays.zipWithIndex) test(s"delay of $clocks clocks by memory", Simulated) {
    memoryDelays.doSim(s"row$clocks", 1) { dut =>
      val random = new Random(1)
      val row = Seq.fill(100)(random.nextInt(32))
      dut.io.a #= 0
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(50)
      for (i <- row.indices) {
        dut.io.a #= row(i)
        dut.clockDomain.waitSampling()
        if (i > clocks) assert(dut.io.b(unit).toInt == row(i - clocks), s"clock $i")
      }
    }
  }
}
