package frustum.boards.icebreaker

import frustum.contract.video.Panel
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.demos.voxel.{Blocks, CompactVoxelConsole}
import frustum.device.Tech
import spinal.core._

/** `icebreaker-voxel`: a world of blocks from the host, on an SPI display whose SCK is the core clock.
  *
  * @param coreMHz core clock
  * @param focal   pixels from the eye to the screen, of the initial camera
  * @param fast    shortens the display's start-up pauses, for simulation
  */
case class VoxelTop(
    config: VoxelConfig,
    panel: Panel,
    focal: Int,
    coreMHz: BigDecimal,
    tech: Tech,
    baud: Int = 460800,
    fast: Int = 1
) extends Component {
  val io = VoxelPins()
  noIoPrefix()

  val clocking = new IcebreakerClock(io.clk, io.resetn, coreMHz, tech)
  val core = new ClockingArea(clocking.domain) {
    val console = CompactVoxelConsole(
      config,
      Blocks.assets,
      VoxelCamera.level(config, focal),
      panel,
      tech,
      baud,
      fast = fast
    )
    console.io.uart := io.uart
    io.refused_n := RegNext(console.io.refused === 0, True)
    io.display := console.io.display
  }
}
