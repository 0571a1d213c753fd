package frustum.scene

import org.joml.Vector3d

/** A bicubic Bezier patch: `control(i)(j)`, i along u and j along v; derivative in u times derivative in v
  * points outwards.
  */
final case class BezierPatch(control: IndexedSeq[IndexedSeq[Vector3d]]) {
  import BezierPatch._

  def point(u: Double, v: Double): Vector3d = sum(bernstein(u), bernstein(v))

  /** Unit normal. Where an edge in v is drawn together into one point (a pole) the derivative in v vanishes;
    * its own derivative in u takes its place, with the sign it has just inside the patch: the limit of the
    * normal.
    */
  def normal(u: Double, v: Double): Vector3d = {
    val du = sum(slope(u), bernstein(v))
    val n = new Vector3d(du).cross(sum(bernstein(u), slope(v)))
    if (n.length > 1e-9) n.normalize
    else {
      val mixed = sum(slope(u), slope(v))
      du.cross(if (u > 0.5) mixed.negate else mixed).normalize
    }
  }

  private def sum(a: Array[Double], b: Array[Double]): Vector3d = {
    val p = new Vector3d
    for (i <- 0 to 3; j <- 0 to 3) p.fma(a(i) * b(j), control(i)(j))
    p
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
