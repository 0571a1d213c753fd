package frustum.demos.voxel

import frustum.contract.video.{Font, TextField, VideoMode}
import frustum.contract.voxel.BlockTable

/** Text over a world of blocks: pictures per second in the top row, below it the name of the current item.
  *
  * @param mode of the monitor, whose dots the letters are made of
  */
final case class VoxelReadout(mode: VideoMode, table: BlockTable) {
  private val letters = table.blocks.map(_.name.length).max.max(VoxelReadout.Digits).min(mode.width / Font.Cell)

  /** The longest name takes at most half of the width, if the smallest letters allow it. */
  private val scale = (0 to 3).findLast(s => mode.width >= 2 * letters * (Font.Cell << s)).getOrElse(0)
  val rate: TextField = TextField(0, 0, VoxelReadout.Digits, scale)
  val item: TextField = TextField(0, 1, letters, scale)

  /** A name in the font's letters. */
  def name(id: Int): String =
    table(id).name.toUpperCase.take(letters).padTo(letters, ' ').map(c => if (Font.has(c)) c else ' ')
}

object VoxelReadout {
  val Digits = 2

  /** Frames of the monitor in which pictures are counted: nearly a second. */
  val Second = 60
}
