package frustum.voxel.march

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.{BlockTable, VoxelConfig, VoxelTextures}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** The face that is pointed at. */
case class PointedAt(c: VoxelConfig) extends Bundle {
  val valid = Bool()
  val block = Vec(UInt(c.size.logs.max bits), 3)
  val face = UInt(3 bits)
}
