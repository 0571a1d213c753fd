package frustum.driver.raster

import frustum.contract.raster.PackedVertex

/** Whether a triangle covers the centre of a pixel in a part of the screen, exactly. Centres on an edge count as
  * covered whichever the edge: more triangles may seem to cover than do, never fewer.
  */
object PixelCover {

  /** @param corners clockwise on the screen */
  def covers(corners: Seq[PackedVertex], box: PixelBox): Boolean =
    (box.y0 to box.y1).exists { row =>
      val (first, last) = corners.indices.foldLeft((box.x0.toLong, box.x1.toLong)) { case ((low, high), i) =>
        narrowed(corners(i), corners((i + 1) % corners.length), row, low, high)
      }
      first <= last
    }

  /** The columns of `low` to `high` whose centres lie on the right of an edge, or on it. With x = 16 column + 8 the
    * edge's function (b - a) x (p - a) is `rest` - 16 dy column, where positive is inside.
    */
  private def narrowed(a: PackedVertex, b: PackedVertex, row: Int, low: Long, high: Long): (Long, Long) = {
    val dy = (b.y - a.y).toLong
    val rest = (b.x - a.x).toLong * (16 * row + 8 - a.y) - dy * (8 - a.x)
    if (dy > 0) (low, high.min(Math.floorDiv(rest, 16 * dy)))
    else if (dy < 0) (low.max(-Math.floorDiv(rest, -16 * dy)), high)
    else if (rest >= 0) (low, high)
    else (1, 0)
  }
}
