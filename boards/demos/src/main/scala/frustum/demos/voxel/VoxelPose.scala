package frustum.demos.voxel

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Where a player stands and looks: middle of the soles in 1/256 block, angles in 1/1024 turn. */
case class VoxelPose(c: VoxelConfig) extends Bundle {
  val feet = Vec(SInt(VoxelPose.width(c) bits), 3)
  val yaw = UInt(VoxelRules.AngleBits bits)
  val pitch = SInt(VoxelRules.AngleBits bits)
}

object VoxelPose {

  /** Of a coordinate. */
  def width(c: VoxelConfig): Int = c.blockBits + 8
}
