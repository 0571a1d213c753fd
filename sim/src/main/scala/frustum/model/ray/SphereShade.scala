package frustum.model.ray

import frustum.spec.RayShade

/** Bit-exact model of the shading of spheres; names and formats as in [[frustum.spec.RayShade]]. */
class SphereShade(format: RayShade) {
  import format._

  private def right(v: Long, by: Int): Long  = if (by >= 0) v >> by else v << -by
  private def zeros(v: Long, top: Int, limit: Int): Int = {
    // In steps of four bits below bit `top`.
    var n = 0
    while (n < limit && (v >> (top - 4 * (n + 1))) == 0) n += 1
    n
  }

  /** sqrt(q) / 2^(rootBits / 2), 16 bits. */
  def squareRoot(q: Long): Long = {
    val y = right(q, rootBits - 28)
    val n = zeros(y, 28, 3)
    root((y >> (12 - 4 * n)).toInt & 0xffff) >> (2 * n)
  }

  /** m with its fraction. */
  def number(q: Long, towards: Long, lit: Long, square: Long): Long = {
    val numerator = (lit >> numeratorShift) - right(towards * squareRoot(q), productShift)
    numerator * reciprocal(right(square, squareBits - 16).toInt) >> numberShift
  }

  /** Of what a sphere's pixel is lit. */
  def apply(q: Long, towards: Long, lit: Long, square: Long, power: Long): Int = {
    val m = number(q, towards, lit, square)
    val d = (power << fraction) - 2 * m
    if (m <= 0 || d <= 0 || power <= 0) 0
    else {
      val n       = zeros(d, distanceBits, 4)
      val x       = right(d, distanceBits - 16 - 4 * n).toInt & 0xffff
      val scaled  = right(m, scaleShift - 2 * n)
      val product = (scaled & 0xffff) * distance(x)
      (product >> 20).min(RayShade.Levels - 1).toInt
    }
  }
}
