package frustum.boards.arty

import frustum.boards.{BoardClock, BoardTop, Part}
import frustum.contract.video.VideoMode
import frustum.contract.voxel.{LeapField, VoxelConfig}
import frustum.demos.pong.PongPipelineConfig
import frustum.demos.voxel.{Blocks, VoxelConsoleConfig}

/** What is built for Digilent's Arty A7. */
object ArtyTops {
  val pong: BoardTop = BoardTop(
    name = "arty-pong",
    part = Part.Artix7A35,
    constraints = "boards/arty/pong.xdc",
    core = BoardClock("clocking_divider_io_clockOut", 25, "a quarter of the 100 MHz oscillator"),
    otherClocks = Seq(BoardClock("clk", 100, "oscillator")),
    component = PongTop(PongPipelineConfig(), _)
  )

  /** The complete world, in words of nine bits, which is what a block RAM has. */
  private def voxelConsole(width: Int, height: Int) = VoxelConsoleConfig(
    VoxelConfig(width = width, height = height, leaps = LeapField.Quadrants),
    Blocks.assets,
    VideoMode.Vga640x480
  )
  val voxelConfig: VoxelConsoleConfig = voxelConsole(320, 240)

  /** What 50 block RAMs hold: a picture of a quarter of the pixels. */
  val voxel35Config: VoxelConsoleConfig = voxelConsole(160, 120)

  val voxel: BoardTop = voxelTop("arty-voxel", Part.Artix7A100, voxelConfig)
  val voxel35: BoardTop = voxelTop("arty-voxel-35t", Part.Artix7A35, voxel35Config)

  /** A world and pictures that exceed the part's block RAMs are refused at elaboration. */
  def voxelTop(name: String, part: Part.Artix7, config: VoxelConsoleConfig): BoardTop = BoardTop(
    name = name,
    part = part,
    constraints = "boards/arty/voxel.xdc",
    core = BoardClock("clk", 100, "oscillator"),
    otherClocks = Seq(),
    component = tech => {
      val (need, have) = (config.memoryBits / 1024, part.blockRamKbit)
      require(
        need <= have,
        s"$name: world and pictures need $need kbit, the ${part.name} has $have in its block RAMs; take a smaller " +
          "world, picture or word"
      )
      VoxelTop(config, tech)
    }
  )
}
