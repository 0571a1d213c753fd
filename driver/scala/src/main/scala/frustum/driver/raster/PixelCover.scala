package frustum.driver.raster

import frustum.contract.raster.PackedVertex

/** Which pixels' centres a triangle covers, exactly. Whether those on an edge count is asked for, whichever the
  * edge: so there may be more than are drawn, or fewer.
  */
object PixelCover {

  /** Whether any is covered in a part of the screen, edges included.
    *
    * @param corners clockwise on the screen
    */
  def covers(corners: Seq[PackedVertex], box: PixelBox): Boolean = (box.y0 to box.y1).exists { row =>
    val (first, last) = columns(corners, row, box.x0, box.x1, strictly = false)
    first <= last
  }

  /** The first and the last column of those that are covered in a row, from `low` to `high`; none where the first is
    * beyond the last.
    *
    * @param strictly without those on an edge
    */
  def columns(corners: Seq[PackedVertex], row: Int, low: Int, high: Int, strictly: Boolean): (Int, Int) = {
    val (first, last) = corners.indices.foldLeft((low.toLong, high.toLong)) { case ((from, to), i) =>
      narrowed(corners(i), corners((i + 1) % corners.length), row, from, to, strictly)
    }
    if (first <= last) (first.toInt, last.toInt) else (1, 0)
  }

  /** The columns whose centres lie on the right of an edge, or on it. With x = 16 column + 8 the edge's function
    * (b - a) x (p - a) is `rest` - 16 dy column, where positive is inside.
    */
  private def narrowed(
      a: PackedVertex,
      b: PackedVertex,
      row: Int,
      low: Long,
      high: Long,
      strictly: Boolean
  ): (Long, Long) = {
    val dy = (b.y - a.y).toLong
    val rest = (b.x - a.x).toLong * (16 * row + 8 - a.y) - dy * (8 - a.x) - (if (strictly) 1 else 0)
    if (dy > 0) (low, high.min(Math.floorDiv(rest, 16 * dy)))
    else if (dy < 0) (low.max(-Math.floorDiv(rest, -16 * dy)), high)
    else if (rest >= 0) (low, high)
    else (1, 0)
  }
}
