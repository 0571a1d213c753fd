package frustum.video

import frustum.contract.video.ScreenTiles
import spinal.core._

/** A finished pixel of a tile: tiles in the order drawn, rows from the top, pixels from the left, only pixels that are
  * on the screen. `first` marks the first pixel of a tile, whose position is `tileX`, `tileY`.
  */
case class ResolvedPixel(config: ScreenTiles) extends Bundle {
  val color = Bits(16 bits) // RGB565
  val first = Bool()
  val tileX = UInt(5 bits)
  val tileY = UInt(5 bits)
}
