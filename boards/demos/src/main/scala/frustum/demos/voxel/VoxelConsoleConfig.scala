package frustum.demos.voxel

import frustum.contract.video.{ColorFormat, PinColor, VideoMode}
import frustum.contract.voxel.{VoxelAssets, VoxelConfig}

/** A world of blocks on a monitor.
  *
  * @param rules   of the player
  * @param focal   pixels from the eye to the screen
  * @param divider cycles of a monitor's pixel
  * @param baud    of the host's serial line
  */
final case class VoxelConsoleConfig(
    voxel: VoxelConfig,
    assets: VoxelAssets,
    rules: VoxelRules,
    focal: Double,
    mode: VideoMode = VideoMode.Vga640x480,
    color: PinColor = PinColor(ColorFormat.Rgb444),
    divider: Int = 4,
    baud: Int = 500000
) {
  require(rules.size == voxel.size, s"rules for a world of ${rules.size} in one of ${voxel.size}")
  require(
    rules.items <= assets.table.blocks.length,
    s"${rules.items} items of ${assets.table.blocks.length} kinds of block"
  )

  /** A picture's pixel is 2^scale of the monitor's wide and high. */
  val scale: Int = (1 to 3)
    .find(s => mode.width == voxel.width << s && mode.height == voxel.height << s)
    .getOrElse(throw new IllegalArgumentException(
      s"requirement failed: a picture of ${voxel.width} x ${voxel.height} is not half, a quarter or an eighth of " +
        s"${mode.name}"
    ))
  require(divider >= 4, s"a monitor's pixel every $divider cycles; a read of the frame buffer takes 4")

  val format: ColorFormat = color.format

  /** Memory of the world and of the two pictures. */
  val memoryBits: Int = voxel.size.blocks * voxel.leaps.wordBits + 2 * voxel.pixels * format.bits
  val start: VoxelStart = VoxelStart.middle(voxel.size)
  val program: CameraProgram = CameraProgram(voxel.width, voxel.height, focal)
  val readout: VoxelReadout = VoxelReadout(mode, assets.table)
}

object VoxelConsoleConfig {

  /** A player who walks, with all blocks of the table, in front of a screen as wide as the original's. */
  def apply(voxel: VoxelConfig, assets: VoxelAssets, mode: VideoMode): VoxelConsoleConfig = VoxelConsoleConfig(
    voxel,
    assets,
    VoxelRules(voxel.size, assets.table.blocks.length),
    225.0 * voxel.height / 240,
    mode
  )
}
