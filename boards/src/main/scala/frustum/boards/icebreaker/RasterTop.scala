package frustum.boards.icebreaker

import frustum.bus.SpiSlave
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.device.Tech
import frustum.raster.RasterPipeline
import frustum.raster.link.LinkStatus
import frustum.video.{PassThrough, SpiDisplay}
import spinal.core._

/** `icebreaker-raster`: commands by SPI, triangles, an SPI display.
  *
  * @param coreMHz core clock; SCK of the display is half of it
  * @param fast    shortens the display's start-up pauses, for simulation
  */
case class RasterTop(config: RasterConfig, panel: Panel, coreMHz: BigDecimal, tech: Tech, fast: Int = 1)
    extends Component {
  val io = RasterPins()
  noIoPrefix()

  val clocking = new IcebreakerClock(io.clk, io.resetn, coreMHz, tech)
  val core = new ClockingArea(clocking.domain) {
    val slave = SpiSlave(LinkStatus.Magic, LinkStatus.Version)
    val pipeline = RasterPipeline(config, dropWhenFull = true, tech = tech)
    val display = SpiDisplay(config, panel, (coreMHz * 1000000).toLong, fast = fast)
    val through = PassThrough()

    slave.io.pins <> io.host
    slave.io.bytes >> pipeline.io.bytes
    slave.io.answer := pipeline.io.status.select(slave.io.ask)
    io.cts := RegNext(pipeline.io.status.cts, False)
    pipeline.io.pixels >> display.io.pixels
    through.io.core <> display.io.pins
    through.io.mux := io.tftMux
    through.io.sck := io.host.sck
    through.io.mosi := io.host.mosi
    through.io.cs := io.tftCs
    through.io.dc := io.tftDc
    through.io.pins <> io.display
  }
}
