package frustum.model.raster.link

import frustum.contract.raster.{RasterConfig, TileRegion}

/** The tiles in which a triangle may cover a pixel centre of the screen, see [[frustum.raster.link.TriangleBox]]. */
object TriangleBox {

  /** Pixels of 0 until `limit` whose centres lie in the coordinates' range, as first and one past the last. */
  def pixels(coordinates: Seq[Int], limit: Int): (Int, Int) = {
    val first = scala.math.floorDiv(coordinates.min + 7, 16)
    val end = scala.math.floorDiv(coordinates.max + 8, 16)
    (first.max(0).min(limit), end.max(0).min(limit))
  }

  def apply(config: RasterConfig, x: Seq[Int], y: Seq[Int]): Option[TileRegion] = {
    val (x0, x1) = pixels(x, config.width)
    val (y0, y1) = pixels(y, config.height)
    if (x0 >= x1 || y0 >= y1) None
    else
      Some(
        TileRegion(
          x0 >> config.tileLog2Width,
          y0 >> config.tileLog2Height,
          (x1 - 1) >> config.tileLog2Width,
          (y1 - 1) >> config.tileLog2Height
        )
      )
  }
}
