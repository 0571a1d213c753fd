package frustum.contract.ray

import frustum.contract.arithmetic.IntVector

/** Where a point may be: on each axis from `low` to `high`. */
case class RayBox(low: IntVector, high: IntVector) {

  /** Squares of the least and the greatest distance between a point of this box and one of another. */
  def nearest(o: RayBox): Long =
    square(a => scala.math.max(0, scala.math.max(low(a) - o.high(a), o.low(a) - high(a))))
  def farthest(o: RayBox): Long =
    square(a => scala.math.max((low(a) - o.high(a)).abs, (high(a) - o.low(a)).abs))
  private def square(along: Int => Int): Long = (0 to 2).map(a => along(a).toLong * along(a)).sum

  override def toString: String = if (low == high) low.toString else s"$low to $high"
}

object RayBox {
  def apply(p: IntVector): RayBox = RayBox(p, p)
}
