package frustum.raster.setup

import frustum.contract.raster.{SetupWord, SetupWords}
import frustum.device.Tech
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

class SetupEngineTest extends AnyFunSuite with Simulated {
  test("constants of the scratch memory outlast whatever the registers hold at power up") {
    val compiled = FrustumSim.compile("SetupEngine")(SetupEngine(6, Tech.Generic))
    for (boot <- 1 to 300) compiled.doSim("boot", boot) { dut =>
      dut.io.run.valid #= false
      dut.io.write.valid #= false
      dut.io.slot #= 0
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(20)
      for (word <- SetupWords.all; value <- Some(word.kind).collect { case SetupWord.Constant(v) => v }) {
        dut.io.read #= dut.memory.code(word)
        dut.clockDomain.waitSampling(2)
        assert(dut.io.readData.toInt == value, s"word $word, boot seed $boot")
      }
    }
  }
}
