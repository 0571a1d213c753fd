package frustum.referee

import scala.math.{hypot, signum}

/** a x + b y + c of a point of the window; what is inside has a positive value. */
final case class Line(a: Double, b: Double, c: Double) {
  def apply(x: Double, y: Double): Double = a * x + b * y + c

  /** In pixels, positive inside; a line that is nowhere near has an infinite one. */
  def distance(x: Double, y: Double): Double = {
    val (value, slope) = (this(x, y), hypot(a, b))
    if (slope > 0) value / slope else if (value >= 0) Double.PositiveInfinity else Double.NegativeInfinity
  }

  /** Whether the point is inside; one on the line itself is for one of the two triangles that share it. */
  def holds(x: Double, y: Double): Boolean = {
    val value = this(x, y)
    value > 0 || (value == 0 && (a > 0 || (a == 0 && b > 0)))
  }
  def *(k: Double): Line = Line(a * k, b * k, c * k)
  def +(o: Line): Line = Line(a + o.a, b + o.b, c + o.c)
}

/** A triangle in the window, also where it reaches behind the eye: scan conversion by homogeneous coordinates (Olano
  * and Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997), which needs no clipping.
  *
  * With the vertices v_i = (x, y, w) the edge functions are E_i = (v_j x v_k) . (x, y, 1), and E_i / sum E are the
  * perspective-correct barycentric coordinates of the point seen there. The sum of E_i f_i over a linear f is linear in
  * the window too; so near (z + w >= 0) and far (w - z >= 0), the clip planes of OpenGL 2.1, 2.12, are two more lines.
  */
final class WindowTriangle(v: IndexedSeq[WindowVertex]) {
  private def cross(p: WindowVertex, q: WindowVertex) =
    Line(p.y * q.w - p.w * q.y, p.w * q.x - p.x * q.w, p.x * q.y - p.y * q.x)
  private val raw = (0 to 2).map(i => cross(v((i + 1) % 3), v((i + 2) % 3)))
  private val determinant = raw(0).a * v(0).x + raw(0).b * v(0).y + raw(0).c * v(0).w

  /** Counter-clockwise in the window, y upwards (OpenGL 2.1, 3.5.1). */
  val isFront: Boolean = determinant > 0

  /** Seen from its edge, or of no extent. */
  val isDegenerate: Boolean = !(determinant.abs > 0) || determinant.isInfinite

  private val edges = raw.map(_ * signum(determinant))
  private val scale = determinant.abs
  private def linear(f: WindowVertex => Double) = (0 to 2).map(i => edges(i) * f(v(i))).reduce(_ + _)
  private val borders = edges ++ Seq(linear(u => u.z + u.w), linear(u => u.w - u.z))

  /** Depth in the window, 0 near to 1 far, as a linear function of the point. */
  val depth: Line = linear(_.z) * (0.5 / scale) + Line(0, 0, 0.5)

  def covers(x: Double, y: Double): Boolean = borders.forall(_.holds(x, y))

  /** Pixels to the nearest border, positive inside; a bound from below outside of a corner. */
  def inside(x: Double, y: Double): Double = borders.map(_.distance(x, y)).min

  /** Perspective-correct weights of the corners at a point. */
  def weights(x: Double, y: Double): IndexedSeq[Double] = {
    val e = edges.map(_(x, y))
    e.map(_ / e.sum)
  }

  /** Weights linear in the window, None where the triangle is cut by the eye's plane. */
  def windowWeights(x: Double, y: Double): Option[IndexedSeq[Double]] =
    Option.when(v.forall(u => u.w > 0))((0 to 2).map(i => edges(i)(x, y) * v(i).w / scale))

  /** None of it is cut off by near or far. */
  val isWhole: Boolean = v.forall(u => u.z.abs <= u.w)

  /** Least and greatest x, then y, of what may show; everything where it reaches behind the eye. */
  val box: (Double, Double, Double, Double) =
    if (v.forall(u => u.w > 0)) {
      val (xs, ys) = (v.map(u => u.x / u.w), v.map(u => u.y / u.w))
      (xs.min, xs.max, ys.min, ys.max)
    } else (Double.NegativeInfinity, Double.PositiveInfinity, Double.NegativeInfinity, Double.PositiveInfinity)
}
