package frustum.raster

import frustum.contract.raster.{RasterConfig, StoreLayout}
import frustum.device.Tech
import frustum.raster.scan.{InterpolatedFragment, Interpolator, RenderStateLoader, Span, TileSequencer}
import frustum.raster.setup.TriangleSetup
import frustum.raster.store.{FrameJob, RenderStateWord, StoreBus}
import frustum.raster.tile.TilePosition
import spinal.core._
import spinal.lib._

/** From a frame in the store to its fragments, tile by tile.
  * {{{
  * frame -> TileSequencer -> TriangleSetup (with EdgeWalker) -> RenderStateLoader -> Interpolator -> fragments
  * }}}
  */
case class Rasterizer(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val frame = slave(Stream(FrameJob(config)))

    /** Clients of the scene store, the most urgent first: set-up, render state, sequencer. */
    val stores = Vec(master(StoreBus(layout)), 3)
    val tile = master(Stream(TilePosition()))
    val state = out(RenderStateWord())
    val draining = in Bool () // fragments in flight after `down`
    val down = master(Stream(InterpolatedFragment(config)))
    val setUp, moved, undrawn = out Bool () // pulses, see TriangleSetup
  }
  val sequencer = TileSequencer(config)
  val setup = TriangleSetup(config, tech)
  val loader = RenderStateLoader(config)
  val interpolator = Interpolator(config)
  val flush = RegNext(!io.frame.valid, True)

  sequencer.io.frame << io.frame
  sequencer.io.tile >> io.tile
  sequencer.io.job >> setup.io.job
  setup.io.token >> loader.io.up
  loader.io.down >> interpolator.io.token
  val spans = StreamFifo(Span(config), 1 << config.tileLog2Height, forFMax = true)
  spans.io.push << setup.io.spans
  spans.io.pop >> interpolator.io.spans
  setup.io.write >> interpolator.io.write
  interpolator.io.down >> io.down

  Seq(setup.io.store, loader.io.store, sequencer.io.store).zip(io.stores).foreach { case (from, to) => from <> to }
  Seq(setup.io.bank, loader.io.bank).foreach(_ := io.frame.bank)
  Seq(setup.io.flush, loader.io.flush).foreach(_ := flush)
  sequencer.io.drained := RegNext(!setup.io.busy && !interpolator.io.busy && !io.draining)
  loader.io.busy := interpolator.io.busy || io.draining
  io.state := loader.io.current
  io.setUp := setup.io.setUp
  io.moved := setup.io.moved
  io.undrawn := setup.io.undrawn
}
