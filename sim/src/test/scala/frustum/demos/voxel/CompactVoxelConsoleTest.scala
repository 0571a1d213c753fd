package frustum.demos.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.voxel.{VoxelCamera, VoxelConfig, VoxelHostCommand, WorldSize}
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.engine.EngineSim
import frustum.engine.voxel.{CompactVoxelPins, CompactVoxelSession}
import frustum.harness.Simulated
import frustum.model.voxel.VoxelModel
import frustum.model.voxel.world.LeapWords
import frustum.peripheral.{SimTftReader, TftController}
import frustum.scene.{Hills, VoxelWorld}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

/** `icebreaker-voxel` at its pins: what a display shows of what a host sends. */
class CompactVoxelConsoleTest extends AnyFunSuite with Simulated {
  private val c = VoxelConfig(size = WorldSize(16, 16, 8), width = 64, height = 48)
  private val focal = 45
  private val start = VoxelCamera.level(c, focal)
  private val world = Hills(c.size, 1)
  private def compiled = EngineSim.compile("SmallVoxelPins")(CompactVoxelPins(c, focal))

  private def shown(world: VoxelWorld, camera: VoxelCamera, highlight: Boolean = true): Array[Int] = {
    val model = new VoxelModel(c, Blocks.assets, world)
    val chosen = if (highlight) model.pointedAt(camera, VoxelConfig.Reach) else None
    (for (j <- 0 until c.height; i <- 0 until c.width)
      yield CompactVoxelSession.rgb565(model.pixel(camera, i, j, chosen).color)).toArray
  }

  private final class Session(dut: CompactVoxelPins) {
    val controller = new TftController(CompactVoxelPins.Panel)
    private val reader =
      new SimTftReader(dut.tft, controller, (CompactVoxelPins.CoreMHz * 2000000).toLong, CompactVoxelPins.Fast)
    dut.io.run #= true
    dut.io.uart #= true
    dut.clockDomain.forkStimulus(EngineSim.Period)
    dut.clockDomain.waitSampling(20)
    reset()

    def reset(): Unit = {
      dut.io.run #= false // an edge: simulated logic sees an asynchronous reset by nothing else
      dut.clockDomain.waitSampling(20)
      dut.io.run #= true
      dut.clockDomain.waitSampling(20)
    }

    def load(world: VoxelWorld): Unit = for ((pair, i) <- LeapWords(world, c.leaps).grouped(2).zipWithIndex)
      dut.top.core.console.pipeline.memory.ram.inferred.setBigInt(i.toLong, BigInt(pair(0) | pair(1) << 8))

    def send(bytes: Seq[Int]): Unit = for ((byte, i) <- bytes.zipWithIndex) {
      if (i == 0) reader.drain()
      for (level <- 0 +: (0 until 8).map(byte >> _ & 1) :+ 1) {
        dut.io.uart #= level == 1
        sleep(2 * 16 * EngineSim.Period)
      }
    }

    /** Lets frames go by until all of the picture is of what there is now. */
    def picture(): Array[Int] = {
      reader.drain()
      val due = controller.pixels + 3 * c.pixels
      var looks = 0
      while (controller.pixels < due) {
        assert(looks < 200, "no frame")
        sleep(EngineSim.Period * 10000)
        dut.clockDomain.waitSampling()
        reader.drain()
        looks += 1
      }
      assert(controller.violations.isEmpty)
      controller.picture(c.width, c.height)
    }
    def clocks: Long = dut.io.clocks.toLong
  }

  private def camera(x: Double, yaw: Double) = VoxelView(Vector3(x, 7.3, 6.4), yaw, -20, focal).camera(c)

  /** An eye whose component `axis` would come out elsewhere if its highest bits were cut. */
  private def far(axis: Int) = {
    val here = camera(3, 200)
    val away = here.eye.axes.updated(axis, here.eye.axes(axis) + (1 << c.blockBits + c.eyeBits))
    here.copy(eye = IntVector(away(0), away(1), away(2)))
  }

  test("without a host: the world from its middle, after a reset in mid-frame again") {
    compiled.doSim("start", 1) { dut =>
      val session = new Session(dut)
      session.load(world)
      assert(session.picture().sameElements(shown(world, start)))
      val (clocks, pixels) = (session.clocks, session.controller.pixels)
      session.picture()
      info(
        f"${(session.clocks - clocks).toDouble / (session.controller.pixels - pixels)}%.2f clocks a pixel at the pins"
      )
      dut.clockDomain.waitSampling(3001)
      session.reset()
      assert(session.picture().sameElements(shown(world, start)))
    }
  }

  test("a world and a camera from the host, none of the world's words lost while pictures are drawn") {
    compiled.doSim("load", 2) { dut =>
      val session = new Session(dut)
      val view = VoxelView(Vector3(8, 7.3, 6.4), 30, -60, focal).camera(c)
      for ((word, address) <- LeapWords(world, c.leaps).zipWithIndex)
        session.send(VoxelHostCommand.write(address, word))
      session.send(VoxelHostCommand.highlight(view))
      val marked = session.picture()
      assert(marked.sameElements(shown(world, view)))
      session.send(VoxelHostCommand.camera(view))
      val plain = session.picture()
      assert(plain.sameElements(shown(world, view, highlight = false)) && !plain.sameElements(marked))
      assert(!dut.io.refused.toBoolean)
    }
  }

  test("after a reset the camera of the start, whatever was half sent") {
    compiled.doSim("reset", 4) { dut =>
      val session = new Session(dut)
      session.load(world)
      for (whole <- 1 to 3) {
        for (view <- Seq(30, 60, 90).take(whole).map(camera(8, _))) {
          session.send(VoxelHostCommand.highlight(view))
          assert(session.picture().sameElements(shown(world, view)))
        }
        session.send(VoxelHostCommand.camera(camera(3, 200)).dropRight(9))
        session.reset()
        assert(session.picture().sameElements(shown(world, start)), s"after $whole cameras and a half")
      }
    }
  }

  test("commands that are wrong change nothing and are counted; the next one is taken") {
    compiled.doSim("wrong", 3) { dut =>
      val session = new Session(dut)
      val good = camera(8, 30)
      session.load(world)
      val refused = dut.top.core.console.host.io.refused
      val wrong = Seq(
        Seq(0x55), // no opcode
        VoxelHostCommand.camera(camera(3, 200)).updated(20, 1), // wrong checksum
        VoxelHostCommand.write(c.size.blocks, c.leaps.wordOfBlock(1)), // outside of the world
        VoxelHostCommand.write(5, 1 << c.leaps.wordBits), // no word
        VoxelHostCommand.block(0, 1), // nothing here works out distances
        VoxelHostCommand.player(IntVector(0, 0, 0), 0, 0), // no player here
        VoxelHostCommand.camera(far(1)),
        VoxelHostCommand.camera(far(2)),
        VoxelHostCommand.camera(camera(3, 200)).take(17) // cut short
      )
      assert(!dut.io.refused.toBoolean)
      wrong.foreach(session.send)
      sleep(EngineSim.Period * 2 * 29 * VoxelHostCommand.SilenceMicros)
      session.send(VoxelHostCommand.highlight(good))
      assert(session.picture().sameElements(shown(world, good)))
      assert(dut.io.refused.toBoolean && refused.toInt == wrong.length)
    }
  }
}
