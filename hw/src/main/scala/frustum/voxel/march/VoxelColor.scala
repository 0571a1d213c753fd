package frustum.voxel.march

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.{BlockTable, VoxelConfig, VoxelTextures}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** A pixel's colour, eight bits a channel. */
case class VoxelColor(c: VoxelConfig) extends Bundle {
  val pixel = UInt(c.pixelBits bits)
  val rgb = Vec(UInt(8 bits), 3)
}
