package frustum.demos.voxel

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** What a host wants done to the world: `content` is a word of its memory or, if `byId`, the id of a block in its low bits. */
case class HostEdit(c: VoxelConfig) extends Bundle {
  val address = UInt(c.size.addressBits bits)
  val content = Bits(c.leaps.wordBits bits)
  val byId = Bool()
}
