package frustum.demos.voxel

import frustum.contract.arithmetic.SineTable
import frustum.contract.voxel.{BlockTable, VoxelConfig, WorldSize}

/** Rules of a walk through a world of blocks: lengths in 1/256 block, angles in 1/1024 turn, time in pictures.
  *
  * @param items     kinds of block to place, ids 1 to this
  * @param collision blocks stop the player
  * @param gravity   the player walks and jumps; otherwise flies
  */
final case class VoxelRules(
    size: WorldSize,
    items: Int,
    collision: Boolean = true,
    gravity: Boolean = true
) {
  import VoxelRules._
  require(items >= 1 && items <= BlockTable.Most, s"$items items; 1 to ${BlockTable.Most} are supported")

  /** Least and greatest of the feet along an axis: the eye stays in the range of the hardware, the feet on or above the
    * world's floor.
    */
  def range(axis: Int): (Int, Int) = {
    val around = (VoxelConfig.Around - 2) << 8
    val end = (size.axes(axis) << 8) + around
    if (axis == 2) (0, end - EyeHeight) else (-around, end)
  }
}

object VoxelRules {
  val AngleBits = SineTable.AngleBits
  val Turn: Int = SineTable.Turn
  val MostPitch = 248 // 87 degrees
  val TurnStep = 10
  val LookStep = 8
  val WalkStep = 38
  val Gravity = 6
  val JumpSpeed = 60
  val MostFall = 200
  val EyeHeight = 410
  val Height = 461
  val HalfWidth = 77
  val RefuseBits = 8

  /** The count of refusals saturates. */
  val MostRefused: Int = (1 << RefuseBits) - 1

  /** From the feet, along an axis, to the body's first place and to the one behind its last. */
  def body(axis: Int): (Int, Int) = if (axis == 2) (0, Height) else (-HalfWidth, HalfWidth)
}
