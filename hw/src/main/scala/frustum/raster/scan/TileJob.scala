package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._

/** A triangle to be drawn in a tile, or the end of the tile. */
case class TileJob(config: RasterConfig) extends Bundle {
  val tileEnd = Bool()
  val tileX = UInt(5 bits)
  val tileY = UInt(5 bits)
  val triangle = UInt(config.triangleBits bits)
  val state = UInt(4 bits)
  val first = Bool() // of the tiles that the triangle's box touches in this frame
}
