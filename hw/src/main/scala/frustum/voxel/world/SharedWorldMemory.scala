package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import frustum.device.{SinglePortRam, Tech}
import spinal.core._
import spinal.lib._

/** The world's memory with one port, two words of at most 8 bits in one of 16: on the iCE40UP5K a world of 64 x 64 x 32
  * is all of its SPRAM. A read is not `granted` in a cycle with a write.
  */
case class SharedWorldMemory(config: VoxelConfig, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val read = slave(WorldReadBus(config))
    val granted = out Bool ()
    val write = slave(Flow(WorldWrite(config)))
  }
  val ram = SinglePortRam(config.size.blocks / 2, 16, tech, maskBits = 8)
  val word = io.write.word.resize(8)
  ram.io.enable := True
  ram.io.write := io.write.valid
  ram.io.address := Mux(io.write.valid, io.write.address, io.read.address) >> 1
  ram.io.writeData := word ## word
  ram.io.mask := io.write.address.lsb ## !io.write.address.lsb
  io.granted := !io.write.valid
  io.read.word := ram.io.readData.subdivideIn(8 bits)(RegNext(io.read.address.lsb).asUInt).resized
}
