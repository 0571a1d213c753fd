package frustum.boards.arty

import spinal.core._

/** Pins of `arty-voxel`, named as in `boards/arty/voxel.xdc`.
  *
  *   - `clk`: 100 MHz
  *   - `resetn`: the red button, low resets
  *   - `uart`: what the host sends by USB, 500 kbaud, 8 bits, no parity, one stop bit
  *   - `refused`: LD4 to LD7, how many of the host's commands were refused, modulo 16
  *   - `pad`: a console's pad on JA, selected while `att` is low; `dat` is pulled up
  *   - `vga`: Digilent's VGA PMOD on JB and JC
  */
case class VoxelPins() extends Bundle {
  val clk, resetn = in Bool ()
  val uart = in Bool ()
  val pad_att, pad_sck, pad_cmd = out Bool ()
  val pad_dat = in Bool ()
  val refused = out UInt (4 bits)
  val vga_red, vga_green, vga_blue = out UInt (4 bits)
  val vga_hSync, vga_vSync = out Bool ()
}
