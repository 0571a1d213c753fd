package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._

/** Reads of the world's memory; the word comes [[WorldReadBus.Latency]] cycles after its address. */
case class WorldReadBus(config: VoxelConfig) extends Bundle with IMasterSlave {
  val address = UInt(config.size.addressBits bits)
  val word = Bits(config.leaps.wordBits bits)

  def asMaster(): Unit = { out(address); in(word) }
}

object WorldReadBus {
  val Latency = 1
}
