package frustum.boards.icebreaker

import frustum.demos.pong.PongButtons
import spinal.core._

/** Pins of `icebreaker-pong`, named as in `boards/icebreaker/pong.pcf`.
  *
  *   - `clk`: 12 MHz; in a simulation the pixel clock itself
  *   - `right`, `up`, `left`: BTN1 to BTN3 of the snap-off board, high when pressed; `down_n`: the user button, low
  *     when pressed
  *   - `dvi`: 12-bit DVI PMOD; its clock rises in the middle of a pixel
  */
case class PongPins() extends Bundle {
  val clk = in Bool ()
  val up, left, right, down_n = in Bool ()
  val dvi_red, dvi_green, dvi_blue = out UInt (4 bits)
  val dvi_hSync, dvi_vSync, dvi_de, dvi_clk = out Bool ()
}
