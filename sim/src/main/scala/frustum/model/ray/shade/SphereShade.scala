package frustum.model.ray.shade

import frustum.contract.ray.{RayShade, ShadeWindow}

/** Bit-exact model of the shading of spheres; names and formats as in [[frustum.contract.ray.RayShade]]. */
class SphereShade(format: RayShade) {
  import RayShade._
  import format._

  private def right(v: Long, by: Int): Long = if (by >= 0) v >> by else v << -by

  /** Steps by which v, of `bits`, is shifted to the left. */
  private def steps(v: Long, bits: Int, w: ShadeWindow): Int = {
    var n = 0
    while (n < w.last && (v >> (bits - w.step * (n + 1))) == 0) n += 1
    n
  }

  /** sqrt(q) / 2^(rootBits / 2), 16 bits. */
  def squareRoot(q: Long): Long = {
    val n = steps(q, rootBits, RootWindow)
    root(right(q, rootBits - 16 - RootWindow.step * n).toInt) >> (RootWindow.step / 2 * n)
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
      val n = steps(d, distanceBits, DistanceWindow)
      val x = right(d, distanceBits - 16 - DistanceWindow.step * n).toInt
      val scaled = right(m, scaleShift - DistanceWindow.step / 2 * n)
      val product = (scaled & 0xffff) * distance(x)
      (product >> LevelShift).min(Levels - 1).toInt
    }
  }
}
