package frustum.reference.raster

import frustum.contract.raster.PackedVertex

/** A texture coordinate in repeats, `numerator / denominator`, the latter positive. */
final case class ExactCoordinate(numerator: BigInt, denominator: BigInt) {

  /** Texel before wrapping, of `size` a repeat: what is exactly a border belongs to the upper texel. */
  def texel(size: Int): Long = {
    val scaled = numerator * size
    ((scaled - scaled.mod(denominator)) / denominator).toLong
  }

  /** Whether it is exactly a texel's border. */
  def onBorder(size: Int): Boolean = (numerator * size).mod(denominator) == 0
}

/** Texture coordinates over a triangle as fractions of its vertices' numbers, nothing rounded: s = sum(l_i s_i q_i) /
  * sum(l_i q_i), with l_i the area opposite to vertex i (Heckbert and Moreton, "Interpolation for polygon texture
  * mapping and shading", 1991). Positions are in 1/16 pixel, coordinates in 1/65536 repeat.
  */
final class ExactCoordinates(v: IndexedSeq[PackedVertex]) {
  private val q = v.map(p => BigInt(p.qMantissa) << p.qExponent)

  /** s and t at the centre of pixel (x, y), which the triangle covers. */
  def apply(x: Int, y: Int): (ExactCoordinate, ExactCoordinate) = {
    val (px, py) = (16 * x + 8, 16 * y + 8)
    def cross(a: PackedVertex, b: PackedVertex) =
      BigInt(b.x - a.x) * (py - a.y) - BigInt(b.y - a.y) * (px - a.x)
    val weights = (0 to 2).map(i => cross(v((i + 1) % 3), v((i + 2) % 3)) * q(i))
    def coordinate(of: PackedVertex => Int) =
      ExactCoordinate(weights.zip(v).map { case (w, p) => w * of(p) }.sum, weights.sum << 16)
    (coordinate(_.s), coordinate(_.t))
  }
}
