package frustum.scene

import frustum.driver.linear.Vector3

/** A bicubic Bezier patch: `control(i)(j)`, i along u and j along v; derivative in u times derivative in v
  * points outwards.
  */
final case class BezierPatch(control: IndexedSeq[IndexedSeq[Vector3]]) {
  import BezierPatch._

  def point(u: Double, v: Double): Vector3 = sum(bernstein(u), bernstein(v))

  /** Unit normal. Where an edge in v is drawn together into one point (a pole) the derivative in v vanishes;
    * its own derivative in u takes its place, with the sign it has just inside the patch: the limit of the
    * normal.
    */
  def normal(u: Double, v: Double): Vector3 = {
    val du = sum(slope(u), bernstein(v))
    val n = du.cross(sum(bernstein(u), slope(v)))
    if (n.length > 1e-9) n.normalized
    else {
      val mixed = sum(slope(u), slope(v))
      du.cross(if (u > 0.5) -mixed else mixed).normalized
    }
  }

  private def sum(a: Array[Double], b: Array[Double]): Vector3 = {
    val terms = for (i <- 0 to 3; j <- 0 to 3) yield control(i)(j) * (a(i) * b(j))
    terms.reduce(_ + _)
  }
}

object BezierPatch {

  /** The four cubic Bernstein polynomials at x. */
  private def bernstein(x: Double): Array[Double] = {
    val y = 1 - x
    Array(y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x)
  }

  /** Their derivatives. */
  private def slope(x: Double): Array[Double] = {
    val y = 1 - x
    Array(-3 * y * y, 3 * y * y - 6 * x * y, 6 * x * y - 3 * x * x, 3 * x * x)
  }
}
