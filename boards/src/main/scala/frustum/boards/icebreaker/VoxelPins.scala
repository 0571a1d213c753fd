package frustum.boards.icebreaker

import frustum.video.DisplayPins
import spinal.core._
import spinal.lib._

/** Pins of `icebreaker-voxel`, named as in `boards/icebreaker/voxel.pcf`.
  *
  *   - `clk`: 12 MHz; in a simulation the core clock itself
  *   - `resetn`: the user button, low resets, not synchronised
  *   - `uart`: what the host sends by USB, 460,800 baud, 8 bits, no parity, one stop bit
  *   - `refused_n`: the red LED, low when a command of the host's has been refused
  *   - `display`: on PMOD 1B, as of `icebreaker-raster`
  */
case class VoxelPins() extends Bundle {
  val clk = in Bool ()
  val resetn = in Bool ()
  val uart = in Bool ()
  val refused_n = out Bool ()
  val display = master(DisplayPins())
}
