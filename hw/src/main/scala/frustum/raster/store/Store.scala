package frustum.raster.store

import frustum.contract.raster.StoreLayout
import frustum.device.{SinglePortRam, Tech}
import spinal.core._
import spinal.lib._

/** The scene store: one access a clock, shared by `clients` with fixed priority, client 0 first. Who has the port is
  * decided a clock ahead, so that no client's valid lies in the way of an address: a request is taken in the clock after
  * it is seen at the earliest, those that follow without a gap at one a clock. While nobody asks, the last client but
  * one, by custom the tile sequencer, has the port. A write must stay until it is taken; a read that is withdrawn costs
  * its clock. A read is answered to its client one clock after it is taken. Only the last client, by custom the decoder,
  * may write: the others' `write` and `data` are not looked at. 16 K x 32 for the default layout: two SPRAM of the
  * iCE40UP5K side by side.
  */
case class Store(layout: StoreLayout, clients: Int, tech: Tech = Tech.Generic) extends Component {
  require(clients >= 2, s"Store: $clients clients, at least 2")
  val io = new Bundle {
    val clients = Vec.fill(Store.this.clients)(slave(StoreBus(layout)))
  }

  val ram = SinglePortRam(1 << layout.addressBits, 32, tech)
  val writer = io.clients.last.cmd
  // Whoever asks now has the port in the next clock, even if what it asks for is being taken: it may ask again.
  val asking = io.clients.map(_.cmd.valid).toSeq
  val first = OHMasking.first(Vec(asking.updated(clients - 2, asking(clients - 2) || !asking.last)))
  val granted = Vec(first.map(RegNext(_, False)))
  val chosen = RegNext(OHToUInt(first)) // the same as a number

  ram.io.enable := True // a read nobody asked for does no harm
  ram.io.write := granted.last && writer.valid && writer.write
  ram.io.address := Vec(io.clients.map(_.cmd.address))(chosen)
  ram.io.writeData := writer.data
  ram.io.mask := B(3, 2 bits)

  for ((client, grant) <- io.clients.zip(granted)) {
    val write = if (client eq io.clients.last) client.cmd.write else False
    client.cmd.ready := grant
    client.rsp.valid := RegNext(client.cmd.fire && !write) init False
    client.rsp.payload := ram.io.readData
  }
}
