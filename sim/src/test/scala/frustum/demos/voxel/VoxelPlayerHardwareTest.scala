package frustum.demos.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.voxel.{LeapField, SeenFace, VoxelConfig, WorldSize}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.demos.voxel.{PlayerCamera => CameraModel, VoxelButtons => Held, VoxelPlayer => PlayerModel}
import frustum.model.voxel.world.LeapWords
import frustum.scene.VoxelWorld
import frustum.voxel.march.{CameraPort, PointedAt}
import frustum.voxel.world.{WorldEditor, WorldMemory}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._
import scala.util.Random

/** The player in hardware, with a world and its editor, against the model: where it is, what it holds, what it changes,
  * what it sees.
  */
class VoxelPlayerHardwareTest extends AnyFunSuite with Simulated {
  private case class Bench(c: VoxelConfig, rules: VoxelRules, program: CameraProgram, start: VoxelStart)
      extends Component {
    val io = new Bundle {
      val frame = in Bool ()
      val buttons = in(VoxelButtons())
      val pointedAt = in(PointedAt(c))
      val place = slave(Flow(VoxelPose(c)))
      val pose = out(VoxelPose(c))
      val rise = out SInt (10 bits)
      val item = out UInt (5 bits)
      val refused = out UInt (8 bits)
      val camera = out(CameraPort(c))
      val done = out Bool ()
    }
    val player = VoxelPlayer(c, rules, Blocks.table, program, start)
    val editor = WorldEditor(c)
    val memory = WorldMemory(c)
    player.io.frame := io.frame
    player.io.buttons := io.buttons
    player.io.pointedAt := io.pointedAt
    player.io.place << io.place
    player.io.load.setIdle()
    player.io.edit >> editor.io.edit
    editor.io.write >> memory.io.write
    memory.io.read.address := Mux(player.io.edit.valid, editor.io.read.address, player.io.read.address)
    editor.io.read.word := memory.io.read.word
    player.io.read.word := memory.io.read.word
    io.pose := player.io.pose
    io.rise := player.io.rise
    io.item := player.io.item
    io.refused := player.io.refused
    io.camera := player.io.camera
    io.done := player.io.done
    memory.words.simPublic()
  }

  private def press(port: VoxelButtons, b: Held): Unit = for (
    (pin, v) <- Seq(
      port.forward -> b.forward,
      port.back -> b.back,
      port.left -> b.left,
      port.right -> b.right,
      port.up -> b.up,
      port.down -> b.down,
      port.turnLeft -> b.turnLeft,
      port.turnRight -> b.turnRight,
      port.lookUp -> b.lookUp,
      port.lookDown -> b.lookDown,
      port.next -> b.next,
      port.previous -> b.previous,
      port.place -> b.place,
      port.destroy -> b.destroy
    )
  ) pin #= v

  private val c = VoxelConfig(size = WorldSize(8, 16, 16), width = 64, height = 48, leaps = LeapField.Quadrants)

  private def walk(rules: VoxelRules, config: VoxelConfig, frames: Int, seed: Int): Unit = {
    val program = CameraProgram(config.width, config.height, 45)
    val start = VoxelStart(IntVector(4 * 256, 8 * 256, 9 * 256), yaw = 100)
    val name = s"VoxelPlayer_${rules.collision}_${rules.gravity}_${config.eyeBits}"
    FrustumSim.compile(name)(Bench(config, rules, program, start)).doSim(seed) { dut =>
      val random = new Random(seed)
      dut.io.frame #= false
      dut.io.place.valid #= false
      dut.clockDomain.forkStimulus(10)
      var world = VoxelWorld.tabulate(config.size)((_, _, z) =>
        if (z < 3 || random.nextInt(12) == 0 && z < 9) 1 + random.nextInt(24) else 0
      )
      dut.clockDomain.waitSampling(3) // before its reset hardware writes what it likes
      for ((w, i) <- LeapWords(world, config.leaps).zipWithIndex) dut.memory.words.setBigInt(i, w)
      var player = PlayerModel(start.feet, start.yaw)
      var held = Held()
      var edits, longest = 0
      for (n <- 0 until frames) {
        if (random.nextInt(3) == 0) { // buttons stay pressed for a while
          def p(of: Int) = random.nextInt(of) == 0
          held = Held(p(2), p(5), p(4), p(4), p(2), p(3), p(4), p(4), p(4), p(4), p(3), p(4), p(2), p(2))
        }
        if (n % 100 == 99) { // out of the world, where nothing may alias
          val feet =
            IntVector(random.between(-20, 27) * 256 + 7, random.between(-20, 35) * 256, random.between(0, 30) * 256)
          player = player.copy(feet = feet, yaw = random.nextInt(1024), pitch = random.between(-248, 249), rise = 0)
          if (n % 200 == 99) { // along an axis, and nothing turns
            player = player.copy(yaw = 256 * random.nextInt(4), pitch = 0)
            held = Held()
          }
          dut.io.place.valid #= true
          for (k <- 0 to 2) dut.io.place.feet(k) #= feet(k)
          dut.io.place.yaw #= player.yaw
          dut.io.place.pitch #= player.pitch
          dut.clockDomain.waitSampling()
          dut.io.place.valid #= false
          dut.clockDomain.waitSampling(2)
        }
        val near = player.feet.axes.map(_ >> 8)
        val spot = config.size.axes.zip(near).map { case (s, f) =>
          Seq(
            random.nextInt(s),
            (f + random.between(-1, 3)).max(0).min(s - 1),
            Seq(0, s - 1)(random.nextInt(2))
          )(random.nextInt(3))
        }
        val seen = Option.when(random.nextInt(4) > 0)(SeenFace(spot(0), spot(1), spot(2), 1, random.nextInt(6), 0, 0))
        dut.io.pointedAt.valid #= seen.isDefined
        for (k <- 0 to 2) dut.io.pointedAt.block(k) #= spot(k)
        dut.io.pointedAt.face #= seen.fold(0)(_.face)
        press(dut.io.buttons, held)
        dut.io.frame #= true
        dut.clockDomain.waitSampling()
        dut.io.frame #= false
        var clocks = 0
        do { dut.clockDomain.waitSampling(); clocks += 1 } while (!dut.io.done.toBoolean && clocks < 200000)
        val (moved, edit) = player.frame(held, rules, Blocks.table, seen, world(_, _, _))
        player = moved
        for (e <- edit) {
          world = world.updated(e.x, e.y, e.z, e.id)
          edits += 1
        }
        if (edit.isEmpty) longest = longest max clocks
        val at = s"seed $seed, frame $n, $held"
        assert(dut.io.pose.feet.map(_.toInt) == player.feet.axes, at)
        assert((dut.io.pose.yaw.toInt, dut.io.pose.pitch.toInt) == ((player.yaw, player.pitch)), at)
        assert(
          (dut.io.rise.toInt, dut.io.item.toInt, dut.io.refused.toInt) == ((player.rise, player.item, player.refused)),
          at
        )
        val camera = CameraModel(player, config, program)
        val port = dut.io.camera
        val pins =
          port.eye.map(_.toInt) ++ Seq(port.look, port.base, port.right, port.down).flatMap(_.axes.map(_.toInt))
        assert(pins == camera.numbers, at)
        if (edit.isDefined || n == frames - 1) for ((w, i) <- LeapWords(world, config.leaps).zipWithIndex)
          assert(dut.memory.words.getBigInt(i).toInt == w, s"$at, word $i")
      }
      info(s"$edits edits, ${player.refused} refused, a turn without edit takes at most $longest clocks")
      assert(edits > frames / 30 && (player.refused > 0 || frames < 400))
    }
  }

  test("walks, jumps, looks, places and destroys as the model does")(walk(VoxelRules(c.size, 24), c, 400, seed = 1))
  test("flies through blocks, where there is neither collision nor gravity; an eye of six bits")(
    walk(VoxelRules(c.size, 24, collision = false, gravity = false), c.copy(eyeBits = 6), 200, seed = 2)
  )
  test("flies, and blocks stop it")(walk(VoxelRules(c.size, 7, gravity = false), c, 200, seed = 3))
}
