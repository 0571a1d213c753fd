package frustum.boards.icebreaker

import frustum.bus.CommandPins
import frustum.video.DisplayPins
import spinal.core._
import spinal.lib._

/** Pins of `icebreaker-raster`, named as in `boards/icebreaker/raster.pcf`.
  *
  *   - `clk`: 12 MHz; in a simulation the core clock itself
  *   - `resetn`: low resets, not synchronised
  *   - `host`: command port, SPI mode 0, `cs` active low; `host_miso` gives [[frustum.raster.link.LinkStatus]]
  *   - `cts`: high while the host may send, see `docs/commands.md`
  *   - `tftMux`: high lets the host drive the display itself, with its `sck`, `mosi`, `tftCs` and `tftDc`
  */
case class RasterPins() extends Bundle {
  val clk = in Bool ()
  val resetn = in Bool ()
  val host = slave(CommandPins())
  val cts = out Bool ()
  val tftMux, tftCs, tftDc = in Bool ()
  val display = master(DisplayPins())
}
