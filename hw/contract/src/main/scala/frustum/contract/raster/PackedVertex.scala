package frustum.contract.raster

/** A vertex as the hardware holds it: screen space, fixed point; on the wire a [[VertexLayout]].
  *
  * @param x   signed, 1/16 pixel, right of the screen's left edge; |x| <= [[PackedVertex.MaxXy]]
  * @param y   signed, 1/16 pixel, below the screen's top edge; |y| <= [[PackedVertex.MaxXy]]
  * @param z   depth, 0 (near) to 65535 (far)
  * @param qMantissa 1/w = qMantissa * 2^(qExponent - 31); 32768 to 65535
  * @param qExponent 0 to 31
  * @param s,t texture coordinates in repeats, 16 fractional bits, |s|, |t| <= [[PackedVertex.MaxSt]]
  * @param r,g,b,a colour, 0 to 255
  *
  * Pixel (i, j) has its centre at (16 i + 8, 16 j + 8).
  */
final case class PackedVertex(
    x: Int,
    y: Int,
    z: Int,
    qMantissa: Int,
    qExponent: Int,
    s: Int,
    t: Int,
    r: Int,
    g: Int,
    b: Int,
    a: Int
) {

  /** Why the hardware refuses this vertex, or None. The decoder makes the same checks. */
  def fault: Option[String] = fault(VertexRanges())

  /** The same for hardware built for these ranges. */
  def fault(ranges: VertexRanges): Option[String] =
    if (x.abs > ranges.maxXy || y.abs > ranges.maxXy)
      Some(s"position ($x, $y)/16 is beyond +-${ranges.maxXy}/16 pixels")
    else if (z < 0 || z > 65535) Some(s"depth $z is outside 0..65535")
    else if (qMantissa < 32768 || qMantissa > 65535) Some(s"1/w mantissa $qMantissa is not normalised (32768..65535)")
    else if (qExponent < 0 || qExponent > 31) Some(s"1/w exponent $qExponent is outside 0..31")
    else if (s.abs > ranges.maxSt || t.abs > ranges.maxSt)
      Some(s"texture coordinate ($s, $t)/65536 is beyond +-${ranges.maxSt}/65536 repeats")
    else if (Seq(r, g, b, a).exists(c => c < 0 || c > 255)) Some(s"colour ($r, $g, $b, $a) is outside 0..255")
    else None

  /** The words of the wire, as [[VertexLayout]] has them. */
  def words: Seq[Int] = {
    import VertexLayout._
    encode(
      X -> x,
      Y -> y,
      Z -> z,
      QMantissa -> qMantissa,
      QExponent -> qExponent,
      S -> s,
      T -> t,
      R -> r,
      G -> g,
      B -> b,
      A -> a
    )
  }
}

object PackedVertex {
  def WireWords: Int = VertexLayout.words

  /** 1/16 pixel units: vertices are strictly within +-1024 pixels of the screen's top left corner. */
  val MaxXy = 16383

  /** Texture coordinates are strictly within +-128 repeats, so that a triangle spans up to 256. */
  val MaxSt = (128 << 16) - 1

  def decode(w: Seq[Int]): PackedVertex = {
    require(w.length == WireWords, s"a vertex has $WireWords words, not ${w.length}")
    import VertexLayout._
    PackedVertex(
      x = X.of(w),
      y = Y.of(w),
      z = Z.of(w),
      qMantissa = QMantissa.of(w),
      qExponent = QExponent.of(w),
      s = S.of(w),
      t = T.of(w),
      r = R.of(w),
      g = G.of(w),
      b = B.of(w),
      a = A.of(w)
    )
  }

  /** 1/w as mantissa and exponent, rounded to nearest; w must be in [[Domain.MinW]]..[[Domain.MaxW]]. */
  def reciprocalW(w: Double): (Int, Int) = {
    require(w >= Domain.MinW && w <= Domain.MaxW, s"w = $w is outside ${Domain.MinW}..${Domain.MaxW}")
    val e = java.lang.Math.getExponent(1 / w)
    val m = scala.math.round(java.lang.Math.scalb(1 / w, 15 - e)).toInt
    if (m == 65536) (32768, e + 17) else (m, e + 16)
  }
}
