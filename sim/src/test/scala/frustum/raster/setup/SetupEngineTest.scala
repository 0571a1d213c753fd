package frustum.raster.setup

import frustum.contract.raster.SetupWords
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
      for ((word, value) <- SetupWords.constants + (SetupWords.Nothing -> 0)) {
        dut.io.read #= SetupWords.code(word, SetupWords.AllPlanes)
        dut.clockDomain.waitSampling(2)
        assert(dut.io.readData.toInt == value, s"word $word, boot seed $boot")
      }
    }
  }
}
