package frustum.demos.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.video.{ColorFormat, PinColor, VideoMode}
import frustum.contract.voxel.{LeapField, SeenFace, VoxelCamera, VoxelConfig, VoxelHostCommand, WorldSize}
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.engine.voxel.{VoxelBoardSession, VoxelBoardTestbed}
import frustum.harness.Simulated
import frustum.model.demos.voxel.{PlayerCamera, VoxelButtons, VoxelMarks, VoxelPlayer, VoxelScreen}
import frustum.model.voxel.VoxelModel
import frustum.model.voxel.world.LeapWords
import frustum.peripheral.SimConsolePad
import frustum.scene.{Hills, VoxelWorld}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import scala.collection.mutable.ArrayBuffer
import scala.util.Random

/** The Arty's top at its pins, with a small picture and world: what a monitor shows of what a host sends and a pad
  * holds.
  */
class VoxelConsoleTest extends AnyFunSuite with Simulated {
  private val c = VoxelConfig(size = WorldSize(16, 16, 16), width = 64, height = 48, leaps = LeapField.Quadrants)
  private val mode = VideoMode("test", 25, 128, 96, 8, 16, 24, 3, 2, 9, hPositive = false, vPositive = false)
  private val config = VoxelConsoleConfig(c, Blocks.assets, mode).copy(baud = 6250000)
  private val world = Hills(c.size, 1)

  private def run(config: VoxelConsoleConfig, seed: Int)(body: (VoxelBoardTestbed, VoxelBoardSession) => Unit): Unit =
    VoxelBoardSession.compile(config).doSim(s"console_$seed", seed) { dut =>
      val session = new VoxelBoardSession(dut)
      session.load(LeapWords(world, c.leaps))
      body(dut, session)
      assert(session.reader.errors == 0)
    }

  /** What the monitor shows of a model's picture. */
  private def shown(
      model: VoxelModel,
      camera: VoxelCamera,
      chosen: Option[SeenFace],
      marks: Option[VoxelMarks],
      console: VoxelConsoleConfig = config
  ): Array[Int] = {
    val small = for (j <- 0 until c.height; i <- 0 until c.width)
      yield console.color(model.pixel(camera, i, j, chosen).color)
    VoxelScreen(console).monitor(small.toArray, marks)
  }
  private def highlighted(world: VoxelWorld, camera: VoxelCamera, console: VoxelConsoleConfig = config): Array[Int] = {
    val model = new VoxelModel(c, Blocks.assets, world)
    shown(model, camera, model.pointedAt(camera, VoxelConfig.Reach), None, console)
  }
  private def camera(x: Double, yaw: Double) = VoxelView(Vector3(x, 7.3, 12.4), yaw, -20, 45).camera(c)

  test("a host's cameras: the picture alone, or with the face in its middle highlighted") {
    run(config, 1) { (_, session) =>
      val down = VoxelView(Vector3(8.2, 7.3, 12.4), 30, -60, 45).camera(c)
      session.send(VoxelHostCommand.highlight(down))
      val high = session.settled()
      assert(high.sameElements(highlighted(world, down)))
      session.send(VoxelHostCommand.camera(down))
      val plain = session.settled()
      assert(plain.sameElements(shown(new VoxelModel(c, Blocks.assets, world), down, None, None)))
      assert(!high.sameElements(plain))
    }
  }

  /** An eye whose component `axis` would come out elsewhere if its highest bits were cut. */
  private def far(axis: Int) = {
    val here = camera(3, 200)
    val away = here.eye.axes.updated(axis, here.eye.axes(axis) + (1 << c.blockBits + c.eyeBits))
    here.copy(eye = IntVector(away(0), away(1), away(2)))
  }

  test("commands that are wrong change nothing and are counted; the next one is taken") {
    run(config, 2) { (dut, session) =>
      val good = camera(8, 30)
      session.send(Seq(0x55)) // no opcode
      session.send(VoxelHostCommand.camera(camera(3, 200)).updated(20, 1)) // wrong checksum
      session.send(VoxelHostCommand.camera(camera(3, 200)).take(17)) // cut short
      session.wait(VoxelHostCommand.SilenceMicros + 100)
      val wrong = Seq(
        VoxelHostCommand.write(c.size.blocks, c.leaps.wordOfBlock(1)), // outside of the world
        VoxelHostCommand.write(5, 1 << c.leaps.wordBits), // no word
        VoxelHostCommand.block(c.size.blocks + 5, 1), // would alias onto block 5
        VoxelHostCommand.block(5, 25), // no such block
        VoxelHostCommand.block(5, 32 + 1),
        VoxelHostCommand.highlight(far(0)),
        VoxelHostCommand.camera(far(2)),
        VoxelHostCommand.player(IntVector(0, 0, -1), 0, 0), // below the floor
        VoxelHostCommand.player(IntVector(0, 40 * 256 + 12 * 256, 0), 0, 0),
        VoxelHostCommand.player(IntVector(0, 0, 0), 1024, 0),
        VoxelHostCommand.player(IntVector(0, 0, 0), 0, 249)
      )
      wrong.foreach(session.send)
      session.send(VoxelHostCommand.highlight(good))
      assert(session.settled().sameElements(highlighted(world, good)))
      assert(session.words(c.size.blocks).sameElements(LeapWords(world, c.leaps)))
      assert(dut.io.refused.toInt == 3 + wrong.length)
    }
  }

  test("100 moving frames with edits: each shows one state whole, in order; the leaps end up right") {
    val seed = 3
    run(config, seed) { (dut, session) =>
      val random = new Random(seed)
      val first = camera(8, 0)
      session.send(VoxelHostCommand.highlight(first))
      var now = world
      var states = Vector(session.settled())
      assert(states.head.sameElements(highlighted(now, first)))
      var last = first
      var index, seen = 0
      for (n <- 0 until 100) {
        val (x, y, z) = (random.nextInt(16), random.nextInt(16), random.nextInt(16))
        val id = if (now(x, y, z) == 0) 1 + random.nextInt(24) else 0
        now = now.updated(x, y, z, id)
        session.send(VoxelHostCommand.block(c.size.address(x, y, z), id))
        states :+= highlighted(now, last)
        last = camera(8 + 3 * scala.math.sin(n / 9.0), 5.0 * n)
        session.send(VoxelHostCommand.highlight(last))
        states :+= highlighted(now, last)
        val frame = session.frame()
        val at = states.indexWhere(_.sameElements(frame), index)
        assert(at >= 0, s"seed $seed, frame $n: no state looks like this")
        if (at > index) seen += 1
        index = at
      }
      assert(seen > 60)
      assert(session.settled().sameElements(states.last))
      assert(session.words(c.size.blocks).sameElements(LeapWords(now, c.leaps)) && dut.io.refused.toInt == 0)
    }
  }

  test("gamma") {
    val bright = config.copy(color = PinColor(ColorFormat.Rgb444, 2.2))
    run(bright, 4) { (_, session) =>
      val view = camera(8, 30)
      session.send(VoxelHostCommand.highlight(view))
      val frame = session.settled()
      assert(frame.sameElements(highlighted(world, view, bright)))
      assert(!frame.sameElements(highlighted(world, view)))
    }
  }

  /** Bytes of a pad with sticks, after the first. */
  private def pad(held: Set[Int], sticks: Seq[Int] = Seq(128, 128, 128, 128)): Seq[Int] = {
    def byte(from: Int) = 0xff - (0 until 8).filter(i => held(from + i)).map(1 << _).sum
    Seq(0x73, 0x5a, byte(0), byte(8)) ++ sticks
  }
  private val Seq(select, start, up, left, l2, r2, r1, triangle, cross, square) = Seq(0, 3, 4, 7, 8, 9, 11, 12, 14, 15)

  test("a walk with a pad: every frame is the model's player's view, crosshair and read-out over it (seed 5)") {
    run(config, 5) { (dut, session) =>
      val controller = new SimConsolePad(dut.io.pad, dut.clockDomain)
      val turns = ArrayBuffer.empty[VoxelButtons] // of each turn of the player since it was placed
      val b = dut.player.io.buttons
      dut.clockDomain.onSamplings {
        if (dut.player.io.frame.toBoolean) turns += VoxelButtons(
          b.forward.toBoolean,
          b.back.toBoolean,
          b.left.toBoolean,
          b.right.toBoolean,
          b.up.toBoolean,
          b.down.toBoolean,
          b.turnLeft.toBoolean,
          b.turnRight.toBoolean,
          b.lookUp.toBoolean,
          b.lookDown.toBoolean,
          b.next.toBoolean,
          b.previous.toBoolean,
          b.place.toBoolean,
          b.destroy.toBoolean
        )
      }
      val program = config.program
      val rules = config.rules
      var model = new VoxelModel(c, Blocks.assets, world)
      var player = VoxelPlayer(config.start.feet, config.start.yaw)
      var pointed = Option.empty[SeenFace]
      var edits, ticks = 0
      val views = ArrayBuffer.empty[Int => Array[Int]] // by the rate that is written over them
      var rates = Seq(0, 0) // as of the frame before and now
      def follow(): Unit = while (ticks < turns.length) {
        val (moved, edit) = player.frame(turns(ticks), rules, Blocks.table, pointed, model.world(_, _, _))
        player = moved
        for (e <- edit) {
          model = new VoxelModel(c, Blocks.assets, model.world.updated(e.x, e.y, e.z, e.id))
          edits += 1
        }
        val camera = PlayerCamera(player, c, program)
        pointed = model.pointedAt(camera, VoxelConfig.Reach)
        val (drawn, chosen, item) = (model, pointed, player.item)
        views += (rate => shown(drawn, camera, chosen, Some(VoxelMarks(rate, item))))
        ticks += 1
      }
      // From the start on, then put above the hills to fall onto them.
      val script = Seq(
        4 -> pad(Set(select)),
        6 -> pad(Set(triangle)),
        10 -> pad(Set(up)),
        6 -> pad(Set(left, up, cross)),
        10 -> pad(Set(square)),
        3 -> pad(Set(r2)),
        3 -> pad(Set()),
        3 -> pad(Set(r2)),
        3 -> pad(Set(r1)),
        3 -> pad(Set()),
        3 -> pad(Set(r1)),
        4 -> pad(Set(l2)),
        8 -> pad(Set(), Seq(255, 20, 128, 0)),
        8 -> pad(Set(), Seq(0, 230, 255, 128)),
        4 -> pad(Set(r2, up)),
        4 -> Nil
      )
      var index = 0
      def shows(view: Int, frame: Array[Int]) = rates.distinct.exists(views(view)(_).sameElements(frame))
      var latest = Array.empty[Int]
      for (((frames, answer), n) <- script.zipWithIndex) {
        controller.answer = answer
        for (f <- 0 until frames) {
          val frame = session.frame()
          latest = frame
          follow()
          rates = Seq(rates.last, dut.rate)
          if (n > 0) {
            // As views may look alike, the first one that does.
            val at = views.indices.drop(index).find(shows(_, frame)).getOrElse(-1)
            assert(
              at >= index,
              s"step $n, frame $f: no view of the player's looks like this after view $index of ${views.length}"
            )
            index = at
          }
        }
      }
      assert(edits >= 2, s"$edits edits")
      assert(rates.last > 50 && rates.last <= 60)
      assert(shows(views.length - 1, latest) && player.item == 3) // at rest, views look alike
      assert(session.words(c.size.blocks).sameElements(LeapWords(model.world, c.leaps)))
      // A pad that is not there is at rest.
      assert(turns.last == VoxelButtons())
    }
  }
}
