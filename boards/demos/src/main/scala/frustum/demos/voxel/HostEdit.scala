package frustum.demos.voxel

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** An edit of the world by a host: `content` is a word of its memory or, if `byId`, the id of a block in its low bits.
  */
case class HostEdit(config: VoxelConfig) extends Bundle {
  val address = UInt(config.size.addressBits bits)
  val content = Bits(config.leaps.wordBits bits)
  val byId = Bool()
}
