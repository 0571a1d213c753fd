package frustum.raster.store

import frustum.contract.raster.StoreLayout
import frustum.device.{SinglePortRam, Tech}
import spinal.core._
import spinal.lib._

/** The scene store: one access per cycle, shared by `clients` with fixed priority, client 0 first. The grant is decided
  * a cycle ahead, so that no client's valid is in the path of an address: a request is taken in the cycle after it
  * appears at the earliest, those that follow without a gap at one per cycle. Without requests the last client but one,
  * by convention the tile sequencer, has the grant. A write must stay until it is taken; a read that is withdrawn costs
  * its cycle. A read is answered to its client one cycle after it is taken. Only the last client, by convention the
  * decoder, may write: the others' `write` and `data` are ignored. 16 K x 32 for the default layout: two SPRAM of the
  * iCE40UP5K in parallel.
  */
case class Store(layout: StoreLayout, clients: Int, tech: Tech = Tech.Generic) extends Component {
  require(clients >= 2, s"Store: $clients clients, at least 2")
  val io = new Bundle {
    val clients = Vec.fill(Store.this.clients)(slave(StoreBus(layout)))
  }

  val ram = SinglePortRam(1 << layout.addressBits, 32, tech)
  val writer = io.clients.last.cmd
  // A requester has the grant in the next cycle, even if its request is taken now: another may follow.
  val asking = io.clients.map(_.cmd.valid).toSeq
  val first = OHMasking.first(Vec(asking.updated(clients - 2, asking(clients - 2) || !asking.last)))
  val granted = Vec(first.map(RegNext(_, False)))
  val chosen = RegNext(OHToUInt(first)) // the granted client as a number

  ram.io.enable := True // a read without a request has no effect
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
