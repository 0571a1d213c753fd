package frustum.voxel.march

import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.engine.EngineSim
import frustum.harness.Simulated
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

class CameraMemoryTest extends AnyFunSuite {
  private val c = VoxelConfig()
  private val start = VoxelCamera.level(c, 225)

  test(
    "what is shown is the newest camera that was whole when it was taken, after a reset that of the start",
    Simulated
  ) {
    EngineSim.compile("CameraMemory")(CameraMemory(c, start)).doSim("random", 1) { dut =>
      val random = simRandom
      var shown, newest = start.numbers
      val written = Array.fill(15)(0)
      var commits, resets = 0
      dut.io.write.valid #= false
      dut.io.commit #= false
      dut.io.take #= false
      dut.clockDomain.forkStimulus(EngineSim.Period)
      dut.clockDomain.waitSampling(20)

      def clock(): Unit = {
        dut.clockDomain.waitSampling()
        dut.io.write.valid #= false
        dut.io.commit #= false
        dut.io.take #= false
      }
      def read(): Unit = for (i <- 0 until 15) {
        dut.io.index #= i
        dut.io.axis #= i % 3
        dut.clockDomain.waitSampling(2)
        sleep(1)
        assert(dut.io.value.toLong == shown(i), s"number $i after $commits commits, $resets resets")
        assert(dut.io.eye.toLong == shown(i % 3), s"eye $i after $commits commits, $resets resets")
      }

      def reset(): Unit = {
        dut.clockDomain.assertReset()
        sleep(EngineSim.Period * 2)
        dut.clockDomain.deassertReset()
        dut.clockDomain.waitSampling()
      }

      for (_ <- 0 until 500) {
        val half = random.nextInt(10) == 0
        for (i <- 0 until (if (half) random.nextInt(15) else 15)) {
          written(i) = random.nextInt(1 << 12)
          dut.io.write.valid #= true
          dut.io.write.index #= i
          dut.io.write.value #= written(i)
          clock()
          if (random.nextInt(20) == 0) {
            shown = newest
            dut.io.take #= true
            clock()
          }
        }
        if (half) {
          resets += 1
          reset()
          shown = start.numbers
          newest = shown
        } else {
          val take = random.nextBoolean()
          if (take) shown = newest
          newest = written.toSeq
          commits += 1
          dut.io.take #= take
          dut.io.commit #= true
          clock()
        }
        read()
      }
      assert(resets > 20)
    }
  }

  test("a start so near to the screen that its rays overflow is refused, one pixel further is not") {
    val near = intercept[IllegalArgumentException](VoxelCamera.level(c, 80))
    assert(near.getMessage.contains("at least 81"))
    val camera = VoxelCamera.level(c, 81)
    for (i <- Seq(0, c.width - 1); j <- Seq(0, c.height - 1); d <- camera.direction(i, j))
      assert(d.abs < (2 << VoxelCamera.DirectionBits))
  }
}
