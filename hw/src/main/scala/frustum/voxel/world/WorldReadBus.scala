package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._

/** Reads of the world's memory; the word comes a clock after its address. */
case class WorldReadBus(c: VoxelConfig) extends Bundle with IMasterSlave {
  val address = UInt(c.size.addressBits bits)
  val word = Bits(c.leaps.wordBits bits)

  def asMaster(): Unit = { out(address); in(word) }
}
