package frustum.raster.tile

import spinal.core._

/** Column and row of a tile on the screen, from the top left. */
case class TilePosition() extends Bundle {
  val tileX, tileY = UInt(5 bits)
}
