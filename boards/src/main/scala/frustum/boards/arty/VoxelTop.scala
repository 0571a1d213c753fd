package frustum.boards.arty

import frustum.demos.voxel.{VoxelConsole, VoxelConsoleConfig}
import frustum.device.Tech
import spinal.core._

/** `arty-voxel` and `arty-voxel-35t`: a world of blocks from the host, a console's pad, a VGA PMOD. All of it runs from
  * the oscillator's 100 MHz; a pixel of the monitor lasts four cycles.
  */
case class VoxelTop(config: VoxelConsoleConfig, tech: Tech) extends Component {
  val io = VoxelPins()
  noIoPrefix()

  val core = new ClockingArea(ArtyDomain(io.clk, io.resetn, 100 MHz)) {
    val console = VoxelConsole(config, tech)
    console.io.uart := io.uart
    console.io.pad.dat := io.pad_dat
    io.pad_att := console.io.pad.att
    io.pad_sck := console.io.pad.sck
    io.pad_cmd := console.io.pad.cmd
    io.refused := console.io.refused.resized
    io.vga_red := console.io.video.red
    io.vga_green := console.io.video.green
    io.vga_blue := console.io.video.blue
    io.vga_hSync := console.io.video.hSync
    io.vga_vSync := console.io.video.vSync
  }
}
