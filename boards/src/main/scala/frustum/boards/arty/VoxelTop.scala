package frustum.boards.arty

import frustum.blackbox.Tech
import frustum.pipelines.VoxelConsole
import frustum.spec.{Blocks, VoxelCamera, VoxelConfig}
import spinal.core._

/** `arty-voxel`: a world of blocks from the host, on a VGA PMOD. All runs from the oscillator's 100 MHz; a pixel of the monitor lasts
  * four clocks.
  */
case class VoxelTop(config: VoxelConfig, tech: Tech) extends Component {
  val io = VoxelPins()
  noIoPrefix()

  val core = new ClockingArea(ArtyDomain(io.clk, io.resetn, 100 MHz)) {
    val console = VoxelConsole(config, Blocks.assets, VoxelCamera.level(config, focal = 225), tech)
    console.io.uart := io.uart
    io.refused      := console.io.refused.resized
    io.vga_red      := console.io.video.red
    io.vga_green    := console.io.video.green
    io.vga_blue     := console.io.video.blue
    io.vga_hSync    := console.io.video.hSync
    io.vga_vSync    := console.io.video.vSync
  }
}
