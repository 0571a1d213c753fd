package frustum.raster.scan

import frustum.contract.raster.{RasterConfig, StoreLayout, StoredState, StoredStateLayout}
import frustum.raster.link.StoreAddress
import frustum.raster.store.{RenderStateWord, StoreBus}
import spinal.core._
import spinal.lib._

/** Holds the render state of the fragment stages. Before a triangle of another state passes, everything in flight
  * drains and the new state is read from the store. Where nothing of a state can be chosen there is nothing to load.
  */
case class RenderStateLoader(config: RasterConfig, stored: StoredStateLayout = StoredState) extends Component {
  val layout = StoreLayout(config, stored)
  val io = new Bundle {
    val flush = in Bool () // a new frame: its states are to be read
    val bank = in UInt (1 bits)
    val busy = in Bool () // fragments in flight
    val store = master(StoreBus(layout))
    val up = slave(Stream(DrawToken(config)))
    val down = master(Stream(DrawToken(config)))
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

    // The state's words are requested one after the other.
    val words = layout.stateWords
    val word = (words > 1) generate Reg(UInt(log2Up(words) bits))
    def isWord(n: Int) = if (words > 1) word === n else True
    val asking = RegInit(False) // a load is in progress, until the last answer
    val start = up.valid && !right && !io.busy && !asking
    val answer = asking && io.store.rsp.valid
    io.store.cmd.valid := RegInit(False) setWhen (start || answer && !isWord(words - 1)) clearWhen io.store.cmd.fire
    io.store.cmd.write := False
    io.store.cmd.data := 0
    io.store.cmd.address := io.bank @@ StoreAddress.state(layout, up.state, if (words > 1) word else U(0, 0 bits))
    asking.setWhen(start)
    if (words > 1) when(start || answer)(word := Mux(start, U(0), word + 1))
    when(answer) {
      for (n <- 0 until words) when(isWord(n))(current.load(stored, n, io.store.rsp.payload))
      when(isWord(words - 1)) {
        asking := False
        index := up.state
        loaded := True
      }
    }
    loaded.clearWhen(io.flush)
  }
}
