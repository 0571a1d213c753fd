package frustum.raster.scan

import frustum.contract.raster.{RasterConfig, StoreLayout}
import frustum.raster.store.{RenderStateWord, StoreBus}
import spinal.core._
import spinal.lib._

/** Holds the render state that the fragment stages see. Before a triangle of another state passes, everything in flight
  * drains and the new state is read from the store. Where nothing of a state can be chosen there is nothing to load.
  */
case class RenderStateLoader(config: RasterConfig, slots: Int) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val flush = in Bool () // a new frame: its states are to be read
    val bank = in UInt (1 bits)
    val busy = in Bool () // fragments in flight
    val store = master(StoreBus(layout))
    val up = slave Stream (DrawToken(config, slots))
    val down = master Stream (DrawToken(config, slots))
    val current = out(RenderStateWord())
  }
  if (config.fixed.whole) {
    io.down << io.up
    io.store.cmd.valid := False
    io.store.cmd.payload.assignDontCare()
    val none = RenderStateWord()
    none.assignDontCare()
    io.current := none.fixed(config.fixed)
  }
  val load = !config.fixed.whole generate new Area {
    val current = Reg(RenderStateWord())
    val index = Reg(UInt(4 bits))
    val loaded = RegInit(False)
    val up = io.up
    val right = up.tileEnd || loaded && index === up.state
    val passes = RegNext(up.valid && right && !up.fire, False)
    io.down << up.continueWhen(passes)
    io.current := current.fixed(config.fixed)

    val asking = RegInit(False) // until the answer
    val start = up.valid && !right && !io.busy && !asking
    io.store.cmd.valid := RegInit(False) setWhen start clearWhen io.store.cmd.fire
    io.store.cmd.write := False
    io.store.cmd.data := 0
    io.store.cmd.address := io.bank @@ (U(layout.states, layout.bankAddressBits bits) + up.state)
    asking.setWhen(start)
    when(asking && io.store.rsp.valid) {
      asking := False
      current.assignFromBits(io.store.rsp.payload.rotateLeft(16)) // the store has the first word in the upper half
      index := up.state
      loaded := True
    }
    loaded.clearWhen(io.flush)
  }
}
