package frustum.raster.link

import frustum.contract.raster.StoreLayout
import frustum.raster.store.StoreBus
import spinal.core._
import spinal.lib._

/** The commands' path to the scene store: one command requests one access at a time. The request reaches the store a
  * cycle later, so that its grant depends on a register only.
  */
case class StorePort(layout: StoreLayout) extends Component {
  val io = new Bundle {
    val bank = in UInt (1 bits)
    val write = slave(Stream(StoreWrite(layout)))
    val read = slave(Stream(UInt(layout.bankAddressBits bits)))
    val store = master(StoreBus(layout))
  }
  val ask = io.write.valid || io.read.valid
  val asking = RegNext(ask && !io.store.cmd.fire) init False
  io.store.cmd.valid := asking
  io.store.cmd.write := !io.read.valid
  io.store.cmd.address := io.bank @@ Mux(io.read.valid, io.read.payload, io.write.address)
  io.store.cmd.data := io.write.data
  io.write.ready := io.store.cmd.fire
  io.read.ready := io.store.cmd.fire
}
