package frustum.boards

import frustum.device.Tech
import frustum.engine.VerilatorSettings
import frustum.harness.Simulated
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.SpinalConfig
import spinal.core.sim._

/** A top's clock and reset at its pins, the PLL replaced by its simulation body. */
class BlinkTopTest extends AnyFunSuite with Simulated {
  test("the reset pin holds the core, and lets it go in step with the clock") {
    VerilatorSettings(SpinalConfig().includeSimulation)
      .compile {
        val top = BlinkTop(36, Tech.Generic)
        top.core.counter.value.simPublic()
        top
      }
      .doSim("pins", seed = 1) { dut =>
        def count = dut.core.counter.value.toInt
        def clocks(n: Int): Unit = for (_ <- 0 until n) {
          dut.io.clk #= false; sleep(10); dut.io.clk #= true; sleep(10)
        }
        dut.io.sck #= false
        dut.io.resetn #= false
        clocks(10)
        assert(count == 0, "held while the pin is low")
        dut.io.resetn #= true
        clocks(20)
        val running = count
        assert(running >= 15 && running < 20, s"after 20 clocks the counter stands at $running")
        dut.io.resetn #= false
        sleep(1)
        assert(count == 0, "reset does not wait for a clock")
      }
  }
}
