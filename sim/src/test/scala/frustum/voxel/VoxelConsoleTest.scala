package frustum.voxel

import frustum.engine.{EngineSim, VoxelConsoleTestbed}
import frustum.harness.FrustumSim
import frustum.host.VoxelView
import frustum.model.pipelines.VoxelModel
import frustum.model.voxel.LeapWords
import frustum.peripheral.SimVideoReader
import frustum.scene.{Hills, VoxelWorld}
import frustum.spec._
import org.joml.Vector3d
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import scala.util.Random

/** The console at its pins: what a monitor shows of what a host sends. */
class VoxelConsoleTest extends AnyFunSuite {
  private val c     = VoxelConfig(size = WorldSize(16, 16, 16), width = 64, height = 48)
  private val mode  = VideoMode("test", 25, 128, 96, 8, 16, 24, 3, 2, 9, hPositive = false, vPositive = false)
  private val start = VoxelCamera.level(c, 45)
  private val baud  = 6250000
  private lazy val compiled = SimConfig
    .withConfig(FrustumSim.spinalConfig.copy(defaultClockDomainFrequency = FixedFrequency(100 MHz)))
    .allOptimisation.workspaceName("VoxelConsole").compile(VoxelConsoleTestbed(
      c,
      Blocks.assets,
      mode,
      start,
      baud
    ))

  /** What the pins show of a model's picture: each channel's upper four bits, each pixel four times. */
  private def atPins(world: VoxelWorld, camera: VoxelCamera): Array[Int] = {
    val model  = new VoxelModel(c, Blocks.assets, world)
    val chosen = model.pointedAt(camera, 6)
    val small  = for (j <- 0 until c.height; i <- 0 until c.width) yield {
      val rgb = model.pixel(camera, i, j, chosen).color
      rgb >> 12 & 0xf00 | rgb >> 8 & 0xf0 | rgb >> 4 & 0xf
    }
    Array.tabulate(mode.width * mode.height)(n => small(n / mode.width / 2 * c.width + n % mode.width / 2))
  }

  private final class Session(dut: VoxelConsoleTestbed, world: VoxelWorld) {
    dut.clockDomain.forkStimulus(EngineSim.Period)
    for ((word, i) <- LeapWords(world, c.leaps).zipWithIndex)
      dut.console.pipeline.memory.words.setBigInt(i.toLong, BigInt(word))
    dut.io.uart #= true
    dut.clockDomain.waitSampling(10)
    val reader = new SimVideoReader(dut.monitor)

    def send(bytes: Seq[Int]): Unit = for (byte <- bytes) {
      val bit = EngineSim.Period * 100000000 / baud
      for (level <- 0 +: (0 until 8).map(byte >> _ & 1) :+ 1) {
        dut.io.uart #= level == 1
        sleep(bit)
      }
    }
    def wait(micros: Int): Unit = sleep(EngineSim.Period * 100 * micros)

    /** The next whole frame. */
    def frame(): Array[Int] = {
      val seen  = reader.frames
      var looks = 0
      while (reader.frames == seen) {
        assert(looks < 200, "no frame")
        sleep(EngineSim.Period * 2000)
        dut.clockDomain.waitSampling()
        looks += 1
      }
      reader.picture()
    }
    def frames(n: Int): Array[Int] = Seq.fill(n)(frame()).last
  }

  private val world                          = Hills(c.size, 1)
  private def camera(x: Double, yaw: Double) = VoxelView(new Vector3d(x, 7.3, 12.4), yaw, -20, 45).camera(c)

  test("without a host: the world from its middle, sync as the mode says") {
    compiled.doSim("start", 1) { dut =>
      val session = new Session(dut, world)
      session.frames(3)
      assert(session.frame().toSeq == atPins(world, start).toSeq)
      assert(session.reader.errors == 0)
    }
  }

  test("commands that are wrong change nothing and are counted; the next one is taken") {
    compiled.doSim("wrong", 2) { dut =>
      val session = new Session(dut, world)
      val good    = camera(8, 30)
      session.send(Seq(0x55))                                                     // no opcode
      session.send(VoxelHostCommand.camera(camera(3, 200)).updated(20, 1))        // wrong checksum
      session.send(VoxelHostCommand.write(c.size.blocks, c.leaps.wordOfBlock(1))) // outside of the world
      session.send(VoxelHostCommand.write(5, 1 << c.leaps.wordBits))              // no word
      session.send(VoxelHostCommand.camera(camera(3, 200)).take(17))              // cut short
      session.wait(VoxelHostCommand.SilenceMicros + 100)
      session.send(VoxelHostCommand.camera(good))
      session.frames(3)
      assert(session.frame().toSeq == atPins(world, good).toSeq)
      assert(dut.io.refused.toInt == 5)
    }
  }

  test("100 moving frames with edits: each shows one state whole, in order") {
    val seed = 3
    compiled.doSim("moving", seed) { dut =>
      val random  = new Random(seed)
      val session = new Session(dut, world)
      var now     = world
      var states  = Vector(atPins(world, start))
      var shown   = 0
      session.frames(3)
      for (n <- 0 until 100) {
        // An edit whose leaps are right: the words around it may all change.
        val (x, y, z)       = (random.nextInt(16), random.nextInt(16), random.nextInt(16))
        val next            = now.updated(x, y, z, if (now(x, y, z) == 0) 1 + random.nextInt(24) else 0)
        val (before, after) = (LeapWords(now, c.leaps), LeapWords(next, c.leaps))
        val changed         = before.indices.filter(i => before(i) != after(i))
        // Blocks that go are cleared first and distances then grow; those that come shorten distances first.
        val order = changed.sortBy(i => (c.leaps.isBlock(after(i)) == (now(x, y, z) == 0), i))
        val view  = camera(8 + 3 * scala.math.sin(n / 9.0), 5.0 * n)
        if (order.length < 60) {
          order.foreach(i => session.send(VoxelHostCommand.write(i, after(i))))
          now = next
        }
        session.send(VoxelHostCommand.camera(view))
        states :+= atPins(now, view)
        val frame = session.frames(3)
        val at    = states.indexWhere(_.sameElements(frame), shown)
        assert(at >= 0, s"seed $seed, frame $n: no state looks like this")
        shown = at
      }
      assert(shown >= 99)
      assert(session.reader.errors == 0 && dut.io.refused.toInt == 0)
    }
  }
}
