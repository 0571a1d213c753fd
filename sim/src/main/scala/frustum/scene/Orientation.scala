package frustum.scene

/** On which side of a directed line a point lies, exactly: the sign of the rounded determinant where it cannot be
  * wrong, else that of the exact one. Bound of the error as in Shewchuk, "Adaptive precision floating-point
  * arithmetic and fast robust geometric predicates" (1997), section 4.3.
  */
object Orientation {
  private val Bound = { val half = math.ulp(1.0) / 2; (3 + 16 * half) * half }

  /** 1 where a, b, c turn counter-clockwise, -1 clockwise, 0 where they lie on a line. */
  def apply(a: Point2, b: Point2, c: Point2): Int = {
    val (left, right) = ((a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x))
    val rounded = left - right
    if (rounded.abs > Bound * (left.abs + right.abs)) rounded.sign.toInt else exact(a, b, c)
  }

  private def exact(a: Point2, b: Point2, c: Point2): Int = {
    def number(v: Double) = new java.math.BigDecimal(v)
    val (cx, cy) = (number(c.x), number(c.y))
    val left = number(a.x).subtract(cx).multiply(number(b.y).subtract(cy))
    left.compareTo(number(a.y).subtract(cy).multiply(number(b.x).subtract(cx)))
  }
}
