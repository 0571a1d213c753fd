package frustum.model.demos.voxel

import frustum.contract.video.{ColorFormat, Crosshair}
import frustum.demos.voxel.VoxelConsoleConfig
import frustum.model.video.TextOverlay

/** What is written over a picture: pictures a second and the item in hand. */
final case class VoxelMarks(rate: Int, item: Int)

/** A monitor's picture of the voxel console, bit for bit: a picture of the pipeline's with colours as the pins have
  * them, enlarged, text and crosshair over it.
  */
final case class VoxelScreen(config: VoxelConsoleConfig) {
  import config.{format, mode, readout, scale, voxel}
  private val cross = Crosshair(voxel.width, voxel.height)

  /** @param small the pins' colours, a picture's pixel each */
  def monitor(small: Array[Int], marks: Option[VoxelMarks]): Array[Int] = {
    val text = TextOverlay(Seq(
      readout.rate -> marks.map(m => f"${m.rate}%02d"),
      readout.item -> marks.map(m => readout.name(m.item))
    ))
    Array.tabulate(mode.width * mode.height) { n =>
      val (x, y) = (n % mode.width, n / mode.width)
      val (i, j) = (x >> scale, y >> scale)
      val inverts = marks.isDefined && cross.covers(i, j)
      val color = small(j * voxel.width + i) ^ (if (inverts) (1 << format.bits) - 1 else 0)
      VoxelScreen.cut(text(VoxelScreen.widened(color, format), x, y), format)
    }
  }
}

object VoxelScreen {

  /** Channels as the upper bits of 0xRRGGBB, and back. */
  private def widened(color: Int, f: ColorFormat): Int =
    (color >> f.green + f.blue) << 24 - f.red |
      (color >> f.blue & (1 << f.green) - 1) << 16 - f.green | (color & (1 << f.blue) - 1) << 8 - f.blue

  private def cut(rgb: Int, f: ColorFormat): Int =
    (rgb >> 24 - f.red) << f.green + f.blue |
      (rgb >> 16 - f.green & (1 << f.green) - 1) << f.blue | rgb >> 8 - f.blue & (1 << f.blue) - 1
}
