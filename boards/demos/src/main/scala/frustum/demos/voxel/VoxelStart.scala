package frustum.demos.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.voxel.WorldSize

/** Where a player begins: middle of the soles in 1/256 block, yaw in 1/1024 turn, level. */
final case class VoxelStart(feet: IntVector, yaw: Int)

object VoxelStart {

  /** The eye is in the middle of the world and looks along +x. */
  def middle(size: WorldSize): VoxelStart =
    VoxelStart(IntVector(size.x << 7, size.y << 7, ((size.z << 7) - VoxelRules.EyeHeight).max(0)), 0)
}
