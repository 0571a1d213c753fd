package frustum.engine.raster

import frustum.contract.raster.{RasterConfig, TileRegion}
import frustum.peripheral.RecordedPixel

/** Puts the pixels of a pass together: tiles of the region row by row, in each of them rows from the top, clipped to
  * the screen. Anything else in the stream is an error that says what came where.
  */
final class TileAssembler(config: RasterConfig, region: TileRegion, into: Array[Int]) {

  def put(pixels: Seq[RecordedPixel]): Unit = {
    val stream = pixels.iterator
    for {
      tileY <- region.y0 to region.y1; tileX <- region.x0 to region.x1
      (left, top) = (tileX * config.tileWidth, tileY * config.tileHeight)
      y <- top until (top + config.tileHeight).min(config.height)
      x <- left until (left + config.tileWidth).min(config.width)
    } {
      val pixel = stream.next()
      if (pixel.tileX != tileX || pixel.tileY != tileY || pixel.first != (x == left && y == top))
        throw new IllegalStateException(
          s"pixel ($x, $y) of tile ($tileX, $tileY) is due, but the pipeline sends ${if (pixel.first) "the first"
            else "another"} " +
            s"pixel of tile (${pixel.tileX}, ${pixel.tileY})"
        )
      into(y * config.width + x) = pixel.color
    }
  }
}
