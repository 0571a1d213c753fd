package frustum.link

import frustum.blackbox.SinglePortRam
import frustum.blackbox.Tech
import frustum.spec.StoreLayout
import spinal.core._
import spinal.lib._

/** The scene store: one access a clock, shared by `clients` with fixed priority, client 0 first. A read is answered to
  * its client one clock after it is granted. Only the last client, by custom the decoder, may write: the others' `write`
  * and `data` are not looked at. 16 K x 32 for the default layout: two SPRAM of the iCE40UP5K side by side.
  */
case class Store(layout: StoreLayout, clients: Int, tech: Tech) extends Component {
  val io = new Bundle {
    val clients = Vec.fill(Store.this.clients)(slave(StoreBus(layout)))
  }

  val ram     = SinglePortRam(1 << layout.addressBits, 32, tech)
  val arbiter = StreamArbiterFactory().lowerFirst.noLock.build(StoreCmd(layout), clients)
  for ((input, client) <- arbiter.io.inputs.zip(io.clients)) input << client.cmd

  val granted = arbiter.io.output
  granted.ready        := True
  ram.io.enable    := granted.valid
  ram.io.write     := arbiter.io.chosenOH.msb && io.clients.last.cmd.write
  ram.io.address   := granted.address
  ram.io.writeData := io.clients.last.cmd.data
  ram.io.mask      := B(3, 2 bits)

  for (client <- io.clients) {
    val write = if (client eq io.clients.last) client.cmd.write else False
    client.rsp.valid   := RegNext(client.cmd.fire && !write) init False
    client.rsp.payload := ram.io.readData
  }
}
