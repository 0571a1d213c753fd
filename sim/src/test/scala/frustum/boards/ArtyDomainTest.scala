package frustum.boards

import frustum.boards.arty.ArtyDomain
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._

/** Counts clocks since it was reset. */
private case class ClockCount() extends Component {
  val io = new Bundle {
    val clk, resetn = in Bool ()
    val count = out UInt (16 bits)
  }
  noIoPrefix()
  val core = new ClockingArea(ArtyDomain(io.clk, io.resetn, 100 MHz)) {
    val count = Reg(UInt(16 bits)) init 0
    count := count + 1
    io.count := count
  }
}

class ArtyDomainTest extends AnyFunSuite with Simulated {
  private lazy val compiled = FrustumSim.compile("ArtyDomain")(ClockCount())

  private def clock(dut: ClockCount, n: Int): Unit = for (_ <- 0 until n) {
    dut.io.clk #= false; sleep(5); dut.io.clk #= true; sleep(5)
  }

  test("power up resets, whatever registers hold and with no button pressed") {
    for (seed <- 1 to 16) compiled.doSim(s"power$seed", seed) { dut =>
      dut.io.resetn #= true
      clock(dut, 40)
      val count = dut.io.count.toInt
      assert(count >= 30 && count < 40, s"seed $seed")
    }
  }

  test("the button resets, and lets go again") {
    compiled.doSim("button", 1) { dut =>
      dut.io.resetn #= true
      clock(dut, 20)
      dut.io.resetn #= false
      clock(dut, 5)
      assert(dut.io.count.toInt == 0)
      dut.io.resetn #= true
      clock(dut, 20)
      assert((15 to 20).contains(dut.io.count.toInt))
    }
  }
}
