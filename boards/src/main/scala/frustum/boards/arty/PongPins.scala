package frustum.boards.arty

import spinal.core._

/** Pins of `arty-pong`, named as in `boards/arty/pong.xdc`.
  *
  *   - `clk`: 100 MHz; in a simulation the pixel clock itself
  *   - `resetn`: the red button, low resets
  *   - buttons BTN0 to BTN3: high when pressed
  *   - `vga`: Digilent's VGA PMOD on JB and JC
  */
case class PongPins() extends Bundle {
  val clk, resetn = in Bool ()
  val up, down, left, right = in Bool ()
  val vga_red, vga_green, vga_blue = out UInt (4 bits)
  val vga_hSync, vga_vSync = out Bool ()
}
