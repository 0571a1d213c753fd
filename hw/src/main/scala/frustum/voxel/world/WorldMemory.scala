package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._

/** A word to be put into the world's memory; see [[frustum.contract.voxel.LeapField]]. */
case class WorldWrite(config: VoxelConfig) extends Bundle {
  val address = UInt(config.size.addressBits bits)
  val word = Bits(config.leaps.wordBits bits)
}

/** The world's memory: one read per cycle, the word [[WorldReadBus.Latency]] cycles later, and one write at the same
  * time.
  */
case class WorldMemory(config: VoxelConfig) extends Component {
  val io = new Bundle {
    val read = slave(WorldReadBus(config))
    val write = slave(Flow(WorldWrite(config)))
  }
  val words = Mem(Bits(config.leaps.wordBits bits), config.size.blocks)
  io.read.word := words.readSync(io.read.address)
  words.write(io.write.address, io.write.word, io.write.valid)
}
