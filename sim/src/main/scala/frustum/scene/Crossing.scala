package frustum.scene

/** Whether two edges of a polygon cross in a point within both; edges that only touch, or lie on each other, do not. */
object Crossing {

  /** Costs a comparison for each pair of edges. */
  def exists(p: IndexedSeq[Point2]): Boolean = {
    def end(i: Int) = p((i + 1) % p.length)
    p.indices.exists(i => (i + 1 until p.length).exists(j => crosses(p(i), end(i), p(j), end(j))))
  }

  private def crosses(a: Point2, b: Point2, c: Point2, d: Point2): Boolean =
    near(a.x, b.x, c.x, d.x) && near(a.y, b.y, c.y, d.y) &&
      Orientation(a, b, c) * Orientation(a, b, d) < 0 && Orientation(c, d, a) * Orientation(c, d, b) < 0

  private def near(a: Double, b: Double, c: Double, d: Double): Boolean =
    a.max(b) >= c.min(d) && c.max(d) >= a.min(b)
}
