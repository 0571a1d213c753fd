package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._

/** A word to be put into the world's memory; see [[frustum.contract.voxel.LeapField]]. */
case class WorldWrite(c: VoxelConfig) extends Bundle {
  val address = UInt(c.size.addressBits bits)
  val word = Bits(c.leaps.wordBits bits)
}

/** The world's memory: a read a clock, the word a clock later, and a write beside it. */
case class WorldMemory(c: VoxelConfig) extends Component {
  val io = new Bundle {
    val read = slave(WorldReadBus(c))
    val write = slave(Flow(WorldWrite(c)))
  }
  val words = Mem(Bits(c.leaps.wordBits bits), c.size.blocks)
  io.read.word := words.readSync(io.read.address)
  words.write(io.write.address, io.write.word, io.write.valid)
}
