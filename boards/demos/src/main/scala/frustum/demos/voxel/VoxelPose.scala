package frustum.demos.voxel

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Position and view of a player: middle of the soles in 1/256 block, angles in 1/1024 turn. */
case class VoxelPose(config: VoxelConfig) extends Bundle {
  val feet = Vec(SInt(VoxelPose.width(config) bits), 3)
  val yaw = UInt(VoxelRules.AngleBits bits)
  val pitch = SInt(VoxelRules.AngleBits bits)
}

object VoxelPose {

  /** Bits of a coordinate. */
  def width(config: VoxelConfig): Int = config.blockBits + 8
}
