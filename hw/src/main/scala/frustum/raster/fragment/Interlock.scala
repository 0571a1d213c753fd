package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.raster.store.RenderStateWord
import frustum.raster.tile.TileClear
import spinal.core._
import spinal.lib._

/** Lets a fragment through to the tests and the tile memories only when they can take it without ever stalling; latency
  * 1 cycle, one per cycle where no two are of one pixel.
  *
  *   - Same pixel: depth is written one cycle after it is read and colour two cycles after, so a fragment follows
  *     another on its pixel by 2 cycles at least, or by 3 when colour is blended. Only the lower bits of the place are
  *     compared: a fragment of another pixel may be held without need, but never a neighbour.
  *   - End of a tile: waits until the tile before has been resolved, so that the bank which is drawn to next is clear.
  *     The fragment passes two cycles after the resolver's last pixel.
  *
  * What to wait for is computed when a fragment enters, so that ready is a register: it stalls everything back to the
  * interpolator. Nothing may be in flight while both banks are cleared, which is what starting a frame waits for.
  */
case class Interlock(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(ColoredFragment(config)))
    val state = in(RenderStateWord())
    val clear = slave(TileClear(config))
    val down = master(Flow(ColoredFragment(config)))
  }
  private def place(f: ColoredFragment): Bits = f.y.take(2) ## f.x.take(3)

  val held = io.up.m2sPipe(collapsBubble = false)
  val stalled = RegInit(False)
  val again = RegInit(False) // a second cycle to wait
  val resolves = RegInit(False) // a tile has ended and is not resolved yet
  held.ready := !stalled

  val before = RegNext(held.fire) init False
  val atBefore = RegNext(place(held.payload))
  val meets1 = held.valid && place(io.up.payload) === place(held.payload)
  val meets2 = before && place(io.up.payload) === atBefore
  // Without reads there is no hazard.
  val meets = Bool(!config.fixed.neverReads) && io.up.valid && !stalled && Mux(io.state.blend, meets1 || meets2, meets1)
  again := Bool(!config.fixed.neverBlends) && io.up.valid && !stalled && meets1 && io.state.blend

  when(io.clear.done) { resolves := False }
  when(held.fire && held.tileEnd) { resolves := True }
  val entersEnd = !stalled && io.up.valid && io.up.tileEnd
  val staysEnd = stalled && held.valid && held.tileEnd
  val endWaits = entersEnd && (resolves || held.valid && held.tileEnd) || staysEnd && resolves
  stalled := meets || again || endWaits
  assert(!(io.clear.all && held.valid), "a fragment meets the clearing of both banks")

  io.down << held.toFlowFire
}
