package frustum.boards.icebreaker

import frustum.boards.{BoardClock, BoardTop, Part}
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.contract.voxel.VoxelConfig
import frustum.demos.pong.PongPipelineConfig

/** What is built for the iCEBreaker. */
object IcebreakerTops {

  /** A frequency the PLL can make of 12 MHz, see [[frustum.device.Ice40PllSettings]]. */
  private val coreMHz = BigDecimal("36")

  /** The highest SCK of the command port. */
  private val hostMHz = BigDecimal(48)

  /** Without the counter of triangles that are left out, for which the logic cells are short. */
  val raster: BoardTop = rasterOf("icebreaker-raster", RasterConfig(countUndrawn = false))

  /** The rasterizer's top, built for a configuration. */
  def rasterOf(name: String, config: RasterConfig): BoardTop = BoardTop(
    name = name,
    part = Part.Ice40Up5k,
    constraints = "boards/icebreaker/raster.pcf",
    core = BoardClock(IcebreakerClock.Net, coreMHz, "PLL on the 12 MHz oscillator"),
    otherClocks = Seq(BoardClock("host_sck", hostMHz, "SCK of the host")),
    component = RasterTop(config, Panel.Ili9341, coreMHz, _)
  )

  /** 59.8 frames a second of 640 x 480: the next to 25.175 MHz that the PLL makes. */
  val pongMHz = BigDecimal("25.125")

  val pongConfig: PongPipelineConfig = PongPipelineConfig()

  val pong: BoardTop = BoardTop(
    name = "icebreaker-pong",
    part = Part.Ice40Up5k,
    constraints = "boards/icebreaker/pong.pcf",
    core = BoardClock(IcebreakerClock.Net, pongMHz, "PLL on the 12 MHz oscillator"),
    otherClocks = Nil,
    component = PongTop(pongConfig, pongMHz, _)
  )

  /** Near 7 cycles per sample of the receiver of 460,800 baud, which samples eight times per bit. */
  val voxelMHz = BigDecimal("25.875")

  val voxel: BoardTop = BoardTop(
    name = "icebreaker-voxel",
    part = Part.Ice40Up5k,
    constraints = "boards/icebreaker/voxel.pcf",
    core = BoardClock(IcebreakerClock.Net, voxelMHz, "PLL on the 12 MHz oscillator"),
    otherClocks = Nil,
    component = VoxelTop(VoxelConfig(), Panel.St7789, focal = 225, voxelMHz, _)
  )
}
