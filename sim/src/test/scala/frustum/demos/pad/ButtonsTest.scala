package frustum.demos.pad

import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class ButtonsTest extends AnyFunSuite with Simulated {
  private lazy val unit = FrustumSim.compile("Buttons")(Buttons(4))

  test("a bounce shorter than the time between looks gives one press; all at once count each") {
    unit.doSim("bounce", 1) { dut =>
      val random = new Random(1)
      dut.io.pins #= 0
      dut.io.sample #= false
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(5)
      var presses = 0
      var before = 0
      for (goal <- Seq(15, 0, 5, 5, 10, 0, 15)) {
        for (look <- 0 until 4) {
          for (t <- 0 until 50) { // bounces for the first half of the first look
            dut.io.pins #= (if (look == 0 && t < 25) goal ^ random.nextInt(16) & (goal ^ before) else goal)
            dut.io.sample #= t == 40
            dut.clockDomain.waitSampling()
            val held = dut.io.held.toInt
            assert(
              (held | before) == (goal | before) && (held & before) == (goal & before) || held == before,
              "only towards the goal"
            )
          }
          if (look == 1) {
            dut.io.sample #= false; dut.clockDomain.waitSampling(2); assert(dut.io.held.toInt == goal)
          }
        }
        if (goal != before) presses += 1
        before = goal
      }
      assert(presses == 6)
    }
  }

  test("a glitch at one look is not a press") {
    unit.doSim("glitch", 2) { dut =>
      dut.io.pins #= 0
      dut.io.sample #= false
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(5)
      for (t <- 0 until 400) {
        dut.io.pins #= (if (t / 50 % 2 == 1) 1 else 0) // at every other look
        dut.io.sample #= t % 50 == 40
        dut.clockDomain.waitSampling()
        assert(dut.io.held.toInt == 0)
      }
    }
  }
}
