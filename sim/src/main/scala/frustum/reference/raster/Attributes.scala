package frustum.reference.raster

/** What a fragment carries. `s`, `t` in repeats; `z` 0..65535; colours 0..255. */
final case class Attributes(s: Double, t: Double, z: Double, r: Double, g: Double, b: Double, a: Double)

/** Attributes over a triangle: texture coordinates perspective-exact,
  * s = sum(lambda_i s_i q_i) / sum(lambda_i q_i) with q = 1/w (Heckbert and Moreton, "Interpolation for
  * polygon texture mapping and shading", 1991), depth and colours linear on the screen. `lambda` are the
  * barycentric coordinates.
  */
final class TriangleAttributes(v: IndexedSeq[ScreenVertex]) {
  private val Seq(v0, v1, v2) = v: Seq[ScreenVertex]

  private def cross(a: ScreenVertex, b: ScreenVertex, px: Double, py: Double) =
    (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)
  private val area = cross(v0, v1, v2.x, v2.y)

  /** At the centre of pixel (x, y). The triangle must not be degenerate. */
  def apply(x: Int, y: Int): Attributes = {
    val (px, py) = (x + 0.5, y + 0.5)
    val l0 = cross(v1, v2, px, py) / area
    val l1 = cross(v2, v0, px, py) / area
    val l2 = cross(v0, v1, px, py) / area
    def linear(f: ScreenVertex => Double) = l0 * f(v0) + l1 * f(v1) + l2 * f(v2)
    val q = linear(_.q)
    Attributes(
      linear(w => w.s * w.q) / q,
      linear(w => w.t * w.q) / q,
      linear(_.z),
      linear(_.r),
      linear(_.g),
      linear(_.b),
      linear(_.a)
    )
  }
}
