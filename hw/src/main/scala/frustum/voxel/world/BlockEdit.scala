package frustum.voxel.world

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import spinal.core._

/** A block of the world that becomes another; id 0 is air. */
case class BlockEdit(config: VoxelConfig) extends Bundle {
  val address = UInt(config.size.addressBits bits)
  val id = UInt(BlockTable.IdBits bits)
}
