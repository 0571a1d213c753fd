package frustum.model.demos.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.voxel.{SeenFace, WorldSize}
import frustum.demos.voxel.{Blocks, VoxelRules}
import frustum.play.VoxelKeys
import java.awt.event.KeyEvent._
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** Movement and edits of the player of a voxel world. */
class VoxelPlayerTest extends AnyFunSuite {
  private val size = WorldSize(16, 16, 16)
  private val rules = VoxelRules(size, 24)
  private val floor = (_: Int, _: Int, z: Int) => z < 4

  private def at(x: Double, y: Double, z: Double, yaw: Int = 0) =
    VoxelPlayer(IntVector((256 * x).toInt, (256 * y).toInt, (256 * z).toInt), yaw)

  private def run(
      p: VoxelPlayer,
      b: VoxelButtons,
      n: Int,
      solid: (Int, Int, Int) => Boolean = floor,
      r: VoxelRules = rules
  ) =
    (0 until n).foldLeft(p)((q, _) => q.tick(b, r, solid))

  test("falls onto the ground and stays there; flies where there is no gravity") {
    val landed = run(at(8, 8, 9), VoxelButtons(), 80)
    assert(landed.feet == IntVector(8 * 256, 8 * 256, 4 * 256) && landed.rise == 0)
    assert(run(landed, VoxelButtons(), 10) == landed)
    val flying = rules.copy(gravity = false)
    assert(run(at(8, 8, 9), VoxelButtons(), 80, r = flying).feet == at(8, 8, 9).feet)
    assert(run(at(8, 8, 9), VoxelButtons(up = true), 10, r = flying).feet.z > 9 * 256)
  }

  test("walks where it looks, sideways at right angles; both at once cancel") {
    val p = at(8, 8, 4)
    for ((yaw, dx, dy) <- Seq((0, 1, 0), (256, 0, 1), (512, -1, 0), (768, 0, -1))) {
      val ahead = run(p.copy(yaw = yaw), VoxelButtons(forward = true), 5).feet - p.feet
      assert(ahead == IntVector(dx * 190, dy * 190, 0), s"yaw $yaw")
      val right = run(p.copy(yaw = yaw), VoxelButtons(right = true), 5).feet - p.feet
      assert(right == IntVector(dy * 190, -dx * 190, 0), s"yaw $yaw")
    }
    assert(run(p, VoxelButtons(forward = true, back = true, left = true, right = true), 5).feet == p.feet)
  }

  test("a jump clears one block and not two") {
    def wall(height: Int)(x: Int, y: Int, z: Int) = z < 4 || x >= 10 && z < 4 + height
    val buttons = VoxelButtons(forward = true, up = true)
    assert(run(at(8, 8, 4), buttons, 60, wall(1)).feet.x > 11 * 256)
    val stopped = run(at(8, 8, 4), buttons, 60, wall(2)).feet
    assert(stopped.x <= 10 * 256 - VoxelRules.HalfWidth)
    assert(run(at(8, 8, 4), buttons, 60, wall(2), rules.copy(collision = false)).feet.x > 11 * 256)
  }

  test("a wall stops one axis, the other slides") {
    val wall = (x: Int, _: Int, z: Int) => z < 4 || x >= 10
    val p = run(at(9, 4, 4, yaw = 128), VoxelButtons(forward = true), 30, wall)
    assert(p.feet.x <= 10 * 256 - VoxelRules.HalfWidth && p.feet.y > 6 * 256)
  }

  test("nobody gets into a block, or out of the eye's range, however buttons are pressed (seeds 1 to 20)") {
    for (seed <- 1 to 20) {
      val random = new Random(seed)
      val solids = Array.fill(16 * 16 * 16)(random.nextInt(8) == 0)
      val solid =
        (x: Int, y: Int, z: Int) => z < 0 || size.contains(x, y, z) && z < 12 && solids(size.address(x, y, z))
      var p = at(8.5, 8.5, 13)
      for (_ <- 0 until 500) {
        def press() = random.nextInt(3) == 0
        p = p.tick(
          VoxelButtons(
            press(),
            press(),
            press(),
            press(),
            press(),
            press(),
            press(),
            press(),
            press(),
            press()
          ),
          rules,
          solid
        )
        assert(!VoxelPlayer.touches(p.feet, solid) && VoxelPlayer.inRange(p.feet, rules), s"seed $seed: $p")
        assert(p.pitch.abs <= VoxelRules.MostPitch && p.yaw >= 0 && p.yaw < VoxelRules.Turn)
      }
    }
  }

  test("pitch is clamped, yaw goes round, items change once a press and go round") {
    assert(run(at(8, 8, 4), VoxelButtons(lookUp = true), 200).pitch == VoxelRules.MostPitch)
    assert(run(at(8, 8, 4), VoxelButtons(lookDown = true), 200).pitch == -VoxelRules.MostPitch)
    assert(run(at(8, 8, 4), VoxelButtons(turnRight = true), 1).yaw == VoxelRules.Turn - VoxelRules.TurnStep)
    assert(run(at(8, 8, 4), VoxelButtons(next = true), 9).item == 2)
    assert(run(at(8, 8, 4), VoxelButtons(previous = true), 9).item == 24)
  }

  test("destroys what is pointed at, places before the face that is seen, once a press") {
    val p = at(8, 8, 4).copy(item = 7)
    val none = VoxelButtons()
    val (place, destroy) = (VoxelButtons(place = true), VoxelButtons(destroy = true))
    def seen(face: Int) = Some(SeenFace(3, 4, 5, 1, face, 0, 0))
    assert(p.edit(destroy, none, seen(0), rules)._2.contains(VoxelEdit(3, 4, 5, 0)))
    val beside = Seq((2, 4, 5), (4, 4, 5), (3, 3, 5), (3, 5, 5), (3, 4, 4), (3, 4, 6))
    for (((x, y, z), face) <- beside.zipWithIndex)
      assert(p.edit(place, none, seen(face), rules)._2.contains(VoxelEdit(x, y, z, 7)))
    assert(p.edit(place, place, seen(0), rules) == ((
      p,
      None
    )) && p.edit(destroy, destroy, seen(0), rules) == ((p, None)))
    assert(p.edit(place, none, None, rules) == ((p, None)))
  }

  test("placing outside of the world or into oneself is refused and counted") {
    val place = VoxelButtons(place = true)
    val p = at(8.5, 8.5, 4)
    for (
      f <- Seq(
        SeenFace(0, 5, 5, 1, 0, 0, 0),
        SeenFace(5, 5, 15, 1, 5, 0, 0),
        SeenFace(8, 8, 3, 1, 5, 0, 0),
        SeenFace(7, 8, 5, 1, 1, 0, 0)
      )
    ) {
      val (counted, edit) = p.edit(place, VoxelButtons(), Some(f), rules)
      assert(edit.isEmpty && counted.refused == 1, f)
    }
  }

  test("water does not stop anybody, glass does") {
    val solid =
      VoxelPlayer.solid(Blocks.table, (x, _, _) => Seq(0, Blocks.id("water"), Blocks.id("glass"))(x))
    assert((0 to 2).map(solid(_, 0, 0)) == Seq(false, false, true))
  }

  test("keys") {
    assert(VoxelKeys(Set(VK_W, VK_LEFT, VK_C)) == VoxelButtons(forward = true, turnLeft = true, place = true))
    assert(VoxelKeys(Set.empty) == VoxelButtons())
  }
}
