package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.raster.store.RenderStateWord
import spinal.core._
import spinal.lib._

/** Drops fragments whose alpha is below the reference; no latency. */
case class AlphaStage(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Flow(ColoredFragment(config)))
    val state = in(RenderStateWord())
    val down = master(Flow(ColoredFragment(config)))
  }
  io.down.valid := io.up.valid && (io.up.tileEnd || io.up.a >= io.state.alphaRef)
  io.down.payload := io.up.payload
}
