package frustum.model.demos.voxel

import frustum.contract.arithmetic.{IntVector, SineTable}
import frustum.contract.voxel.{BlockTable, SeenFace}
import frustum.demos.voxel.VoxelRules
import frustum.demos.voxel.VoxelRules._
import scala.math.floorMod

/** A block that becomes another; id 0 is air. */
final case class VoxelEdit(x: Int, y: Int, z: Int, id: Int)

/** A player in a world of blocks, moved once a frame; whole numbers throughout.
  *
  * @param feet    middle of the soles, 1/256 block
  * @param yaw     1/1024 turn, 0 along +x, 256 along +y
  * @param pitch   1/1024 turn, up is positive, within +-[[VoxelRules.MostPitch]]
  * @param rise    upward speed, 1/256 block a frame
  * @param item    id of the block that is placed
  * @param held    buttons of the frame before
  * @param refused edits outside of the world, or where the player stands; the count stays at its end
  */
final case class VoxelPlayer(
    feet: IntVector,
    yaw: Int = 0,
    pitch: Int = 0,
    rise: Int = 0,
    item: Int = 1,
    held: VoxelButtons = VoxelButtons(),
    refused: Int = 0
) {
  import VoxelPlayer._

  /** 1/256 block. */
  def eye: IntVector = IntVector(feet.x, feet.y, feet.z + EyeHeight)

  /** A picture on: first what the buttons do to the block that the last picture showed in its middle, then the move.
    *
    * @param id what is at x, y, z
    */
  def frame(
      b: VoxelButtons,
      rules: VoxelRules,
      table: BlockTable,
      pointedAt: Option[SeenFace],
      id: (Int, Int, Int) => Int
  ): (VoxelPlayer, Option[VoxelEdit]) = {
    val (counted, change) = edit(b, held, pointedAt, rules)
    def now(x: Int, y: Int, z: Int) =
      change.filter(e => (e.x, e.y, e.z) == ((x, y, z))).fold(id(x, y, z))(_.id)
    (counted.tick(b, rules, solid(table, now)), change)
  }

  /** The next frame's player.
    *
    * @param solid whether the block at x, y, z stops a player, anywhere
    */
  def tick(b: VoxelButtons, rules: VoxelRules, solid: (Int, Int, Int) => Boolean): VoxelPlayer = {
    def both(plus: Boolean, minus: Boolean) = (if (plus) 1 else 0) - (if (minus) 1 else 0)
    val turned = copy(
      yaw = floorMod(yaw + TurnStep * both(b.turnLeft, b.turnRight), Turn),
      pitch = (pitch + LookStep * both(b.lookUp, b.lookDown)).max(-MostPitch).min(MostPitch),
      item =
        floorMod(item - 1 + both(b.next && !held.next, b.previous && !held.previous), rules.items) + 1,
      held = b
    )
    val (ahead, aside) = (both(b.forward, b.back), both(b.right, b.left))
    val (c, s) = (SineTable.coarse(turned.yaw + Turn / 4), SineTable.coarse(turned.yaw))
    val (dx, dy) = ((WalkStep * (ahead * c + aside * s)) >> 8, (WalkStep * (ahead * s - aside * c)) >> 8)
    turned.moved(dx, dy, rules, b, solid)
  }

  /** Axis by axis; what is in the way ends the move along its axis alone. */
  private def moved(
      dx: Int,
      dy: Int,
      rules: VoxelRules,
      b: VoxelButtons,
      solid: (Int, Int, Int) => Boolean
  ): VoxelPlayer = {
    def free(p: IntVector) = !rules.collision || !touches(p, solid) || touches(feet, solid)
    def step(from: IntVector, to: IntVector) = if (inRange(to, rules) && free(to)) to else from
    val flat = step(feet, IntVector(feet.x + dx, feet.y, feet.z))
    val along = step(flat, IntVector(flat.x, flat.y + dy, flat.z))
    val below = IntVector(along.x, along.y, along.z - 1)
    val stands = step(along, below) == along
    val lift =
      if (!rules.gravity) WalkStep * ((if (b.up) 1 else 0) - (if (b.down) 1 else 0))
      else if (stands && b.up) JumpSpeed
      else if (stands && rise <= 0) 0
      else (rise - Gravity).max(-MostFall)
    val raised = IntVector(along.x, along.y, along.z + lift)
    val settled = step(along, raised)
    if (settled == raised) copy(feet = settled, rise = lift)
    else copy(feet = if (lift < 0) IntVector(along.x, along.y, along.z & ~255) else along, rise = 0)
  }

  /** What a press of place or destroy does to the block pointed at; the player with it, who counts what is refused. */
  def edit(
      b: VoxelButtons,
      before: VoxelButtons,
      pointedAt: Option[SeenFace],
      rules: VoxelRules
  ): (VoxelPlayer, Option[VoxelEdit]) =
    pointedAt match {
      case Some(f) if b.destroy && !before.destroy => (this, Some(VoxelEdit(f.x, f.y, f.z, 0)))
      case Some(f) if b.place && !before.place     =>
        val axis = f.face / 2
        val step = if (f.face % 2 == 0) -1 else 1 // a ray that travels up meets the bottom
        val Seq(x, y, z) = Seq(f.x, f.y, f.z).zipWithIndex.map { case (v, k) =>
          if (k == axis) v + step else v
        }
        if (!rules.size.contains(x, y, z) || touches(feet, (i, j, k) => (i, j, k) == ((x, y, z))))
          (copy(refused = (refused + 1).min(MostRefused)), None)
        else (this, Some(VoxelEdit(x, y, z, item)))
      case _ => (this, None)
    }
}

object VoxelPlayer {

  /** Whether a body with its feet there touches a solid block. */
  def touches(feet: IntVector, solid: (Int, Int, Int) => Boolean): Boolean = {
    def blocks(axis: Int) = {
      val (low, high) = body(axis)
      (feet(axis) + low >> 8) to (feet(axis) + high - 1 >> 8)
    }
    (for (x <- blocks(0).iterator; y <- blocks(1); z <- blocks(2)) yield solid(x, y, z)).exists(identity)
  }

  def inRange(feet: IntVector, rules: VoxelRules): Boolean =
    (0 to 2).forall { k =>
      val (low, high) = rules.range(k); feet(k) >= low && feet(k) <= high
    }

  /** Everything that can be pointed at stops a player; water does not. */
  def solid(table: BlockTable, id: (Int, Int, Int) => Int): (Int, Int, Int) => Boolean =
    (x, y, z) => { val i = id(x, y, z); i != 0 && table(i).selectable }
}
