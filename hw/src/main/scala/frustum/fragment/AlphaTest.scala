package frustum.fragment

import frustum.raster.RenderStateWord
import frustum.spec.RasterConfig
import spinal.core._
import spinal.lib._

/** Drops fragments whose alpha is below the reference; no latency. */
case class AlphaTest(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up    = slave(Stream(ColoredFragment(config)))
    val state = in(RenderStateWord())
    val down  = master(Stream(ColoredFragment(config)))
  }
  io.down << io.up.throwWhen(io.up.a < io.state.alphaRef && !io.up.tileEnd)
}
