package frustum.voxel.world

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import spinal.core._

/** A block of the world that becomes another; id 0 is air. */
case class BlockEdit(c: VoxelConfig) extends Bundle {
  val address = UInt(c.size.addressBits bits)
  val id = UInt(BlockTable.IdBits bits)
}
