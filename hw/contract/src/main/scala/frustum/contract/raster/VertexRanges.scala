package frustum.contract.raster

/** Ranges of the numbers of a scene's vertices, as powers of two; hardware for smaller ones is narrower. A vertex
  * outside is refused.
  *
  * @param position |x|, |y| < 2^position pixels
  * @param repeats  |s|, |t| < 2^repeats
  * @param ratio    within a triangle the greatest w is at most 2^ratio times the least; the driver ensures it, hardware
  *                 does not check it: above it coordinates are wrong
  */
final case class VertexRanges(position: Int = 10, repeats: Int = 7, ratio: Int = 15) {
  require(position >= 4 && position <= 10, s"positions below 2^$position pixels: 2^4..2^10")
  require(repeats >= 0 && repeats <= 7, s"coordinates below 2^$repeats repeats: 2^0..2^7")
  require(ratio >= 1 && ratio <= 15, s"w ratios up to 2^$ratio: 2^1..2^15")

  /** Greatest magnitudes, in the units of [[PackedVertex]]. */
  def maxXy: Int = (16 << position) - 1
  def maxSt: Int = (65536 << repeats) - 1

  /** Bits of an edge function's step (per 1/16 pixel) and of the function itself (1/16 pixel^2) in a tile that the
    * triangle touches.
    */
  def stepBits: Int = if (position == 10) 17 else position + 6
  def edgeBits: Int = 2 * position + 8

  /** Bits of a position, 1/16 pixel. */
  def positionBits: Int = position + 5

  /** Bits of the planes of s/w and t/w, 23 of them a fraction: all 32, or the sign and the bits of the range. */
  def coordinateBits: Int = if (repeats == 7) 32 else 24 + repeats

  /** A value of such a plane as its hardware holds it. */
  def wrap(coordinate: Int): Int = coordinate << (32 - coordinateBits) >> (32 - coordinateBits)
}

object VertexRanges {

  /** Greatest `ratio` that the smaller divide, [[frustum.raster.texture.LateDivide]], is built for. */
  val LateRatio = 3
}
