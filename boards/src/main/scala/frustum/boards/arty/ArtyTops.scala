package frustum.boards.arty

import frustum.blackbox.Tech
import frustum.boards.{BoardClock, BoardTop, Part}
import frustum.pipelines.PongPipelineConfig
import frustum.spec.{LeapField, VoxelConfig}

/** What is built for Digilent's Arty A7. */
object ArtyTops {
  val pong: BoardTop = BoardTop(
    name = "arty-pong",
    part = Part.Artix7A35,
    constraints = "boards/arty/pong.xdc",
    core = BoardClock("clocking_divider_io_clockOut", 25, "a quarter of the 100 MHz oscillator"),
    otherClocks = Seq(BoardClock("clk", 100, "oscillator")),
    component = () => PongTop(PongPipelineConfig(), Tech.Artix7)
  )

  val voxel: BoardTop = BoardTop(
    name = "arty-voxel",
    part = Part.Artix7A100,
    constraints = "boards/arty/voxel.xdc",
    core = BoardClock("clk", 100, "oscillator"),
    otherClocks = Seq(),
    component = () => VoxelTop(VoxelConfig(leaps = LeapField.Octants), Tech.Artix7)
  )
}
