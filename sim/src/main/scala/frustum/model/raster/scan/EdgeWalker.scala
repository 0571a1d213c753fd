package frustum.model.raster.scan

/** Pixels `first` to `last` of row `y`, inclusive. */
final case class Span(y: Int, first: Int, last: Int)

/** Bit-exact edge walker: the rows of a window with the pixels that three edge functions accept. */
object EdgeWalker {

  /** @param edge  values at (left or right end of the window by the sign of stepX, top), 1/256 pixel^2
    * @param stepX,stepY change of the edge function per 1/16 pixel
    */
  def spans(
      left: Int,
      right: Int,
      top: Int,
      bottom: Int,
      edge: Array[Int],
      stepX: Int => Int,
      stepY: Int => Int
  ): Seq[Span] = {
    val width = right - left + 1
    // sixteenths are the same at every pixel centre: drop them, and let an exact zero count as outside
    // unless the edge is a top or left one
    val topLeft = (k: Int) => stepX(k) > 0 || (stepX(k) == 0 && stepY(k) > 0)
    val start = Array.tabulate(3)(k => (edge(k) >> 4) - (if ((edge(k) & 15) == 0 && !topLeft(k)) 1 else 0))
    for {
      y <- top to bottom
      // how many pixels each edge cuts off its side of the row
      cut = (0 to 2).map { k =>
        val e = start(k).toLong + stepY(k).toLong * (y - top)
        val a = stepX(k).abs
        if (e >= 0) 0 else if (a == 0) width else scala.math.min(width.toLong, (-e + a - 1) / a).toInt
      }
      first = left + (0 to 2).filter(stepX(_) >= 0).map(cut).max
      last = right - (0 +: (0 to 2).filter(stepX(_) < 0).map(cut)).max
      if first <= last
    } yield Span(y, first, last)
  }
}
