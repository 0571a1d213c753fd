package frustum.model.game

import frustum.scene.SeenFace
import frustum.spec.{BlockTable, IntVector, VoxelConfig, WorldSize}
import scala.math.{Pi, floorMod, round, sin}

/** What a player of a voxel world holds down. */
final case class VoxelButtons(
    forward: Boolean = false,
    back: Boolean = false,
    left: Boolean = false,
    right: Boolean = false,
    up: Boolean = false,
    down: Boolean = false,
    turnLeft: Boolean = false,
    turnRight: Boolean = false,
    lookUp: Boolean = false,
    lookDown: Boolean = false,
    next: Boolean = false,
    previous: Boolean = false,
    place: Boolean = false,
    destroy: Boolean = false
)

/** A block that becomes another; id 0 is air. */
final case class VoxelEdit(x: Int, y: Int, z: Int, id: Int)

/** A player in a world of blocks, moved once a frame; whole numbers throughout.
  *
  * @param feet    middle of the soles, 1/256 block
  * @param yaw     1/1024 turn, 0 along +x, 256 along +y
  * @param pitch   1/1024 turn, up is positive, within +-[[VoxelPlayer.MostPitch]]
  * @param rise    upward speed, 1/256 block a frame
  * @param item    id of the block that is placed
  * @param held    buttons of the frame before
  * @param refused edits outside of the world, or where the player stands
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

  /** The next frame's player.
    *
    * @param solid whether the block at x, y, z stops a player, anywhere
    */
  def tick(b: VoxelButtons, rules: VoxelRules, solid: (Int, Int, Int) => Boolean): VoxelPlayer = {
    def both(plus: Boolean, minus: Boolean) = (if (plus) 1 else 0) - (if (minus) 1 else 0)
    val turned                              = copy(
      yaw = floorMod(yaw + TurnStep * both(b.turnLeft, b.turnRight), Turn),
      pitch = (pitch + LookStep * both(b.lookUp, b.lookDown)).max(-MostPitch).min(MostPitch),
      item =
        floorMod(item - 1 + both(b.next && !held.next, b.previous && !held.previous), rules.items) + 1,
      held = b
    )
    val (ahead, aside) = (both(b.forward, b.back), both(b.right, b.left))
    val (c, s)         = (sine(turned.yaw + Turn / 4), sine(turned.yaw))
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
    def free(p: IntVector)                   = !rules.collision || !touches(p, solid) || touches(feet, solid)
    def step(from: IntVector, to: IntVector) = if (inRange(to, rules.size) && free(to)) to else from
    val flat                                 = step(feet, IntVector(feet.x + dx, feet.y, feet.z))
    val along                                = step(flat, IntVector(flat.x, flat.y + dy, flat.z))
    val below                                = IntVector(along.x, along.y, along.z - 1)
    val stands                               = step(along, below) == along
    val lift                                 =
      if (!rules.gravity) WalkStep * ((if (b.up) 1 else 0) - (if (b.down) 1 else 0))
      else if (stands && b.up) JumpSpeed
      else if (stands && rise <= 0) 0
      else (rise - Gravity).max(-MostFall)
    val raised  = IntVector(along.x, along.y, along.z + lift)
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
        val axis         = f.face / 2
        val step         = if (f.face % 2 == 0) -1 else 1 // a ray that travels up meets the bottom
        val Seq(x, y, z) = Seq(f.x, f.y, f.z).zipWithIndex.map { case (v, k) =>
          if (k == axis) v + step else v
        }
        if (!rules.size.contains(x, y, z) || touches(feet, (i, j, k) => (i, j, k) == ((x, y, z))))
          (copy(refused = refused + 1), None)
        else (this, Some(VoxelEdit(x, y, z, item)))
      case _ => (this, None)
    }
}

/** @param items    kinds of block to place, 1 to this
  * @param collision blocks stop the player
  * @param gravity  the player walks and jumps; otherwise flies
  */
final case class VoxelRules(size: WorldSize, items: Int, collision: Boolean = true, gravity: Boolean = true)

object VoxelPlayer {
  val Turn      = 1024
  val MostPitch = 248 // 87 degrees
  val TurnStep  = 10
  val LookStep  = 8
  val WalkStep  = 38
  val Gravity   = 6
  val JumpSpeed = 60
  val MostFall  = 200
  val EyeHeight = 410
  val Height    = 461
  val HalfWidth = 77

  private val sines = Array.tabulate(Turn)(i => round(256 * sin(2 * Pi * i / Turn)).toInt)

  /** Of 1/1024 turns, 8 fraction bits. */
  def sine(angle: Int): Int = sines(floorMod(angle, Turn))

  /** Whether a body with its feet there touches a solid block. */
  def touches(feet: IntVector, solid: (Int, Int, Int) => Boolean): Boolean = {
    def blocks(low: Int, high: Int) = (low >> 8) to ((high - 1) >> 8)
    (for {
      x <- blocks(feet.x - HalfWidth, feet.x + HalfWidth).iterator
      y <- blocks(feet.y - HalfWidth, feet.y + HalfWidth)
      z <- blocks(feet.z, feet.z + Height)
    } yield solid(x, y, z)).exists(identity)
  }

  /** Whether the eye stays where the hardware takes it, and the feet on or above the world's floor. */
  def inRange(feet: IntVector, size: WorldSize): Boolean = {
    val around = (VoxelConfig.Around - 2) << 8
    feet.z >= 0 && feet.z + EyeHeight <= (size.z << 8) + around &&
    Seq(feet.x -> size.x, feet.y -> size.y).forall { case (p, n) => p >= -around && p <= (n << 8) + around }
  }

  /** Everything that can be pointed at stops a player; water does not. */
  def solid(table: BlockTable, id: (Int, Int, Int) => Int): (Int, Int, Int) => Boolean =
    (x, y, z) => { val i = id(x, y, z); i != 0 && table(i).selectable }
}
