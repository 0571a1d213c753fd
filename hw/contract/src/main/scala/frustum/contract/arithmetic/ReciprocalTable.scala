package frustum.contract.arithmetic

/** Table of r(f) = 2 f / (1 + f) for f in [0, 1), by which 1 / (1 + f) = 1 - r / 2 without a division: 256
  * intervals, each a line. Hardware and model read the same words.
  *
  * With i the top 8 bits of f and x the next [[FractionBits]] bits,
  * {{{r = (base(i) * 2^13 + slope(i) * x) >> 16     in units of 2^-16, 0..65535}}} `base` has 3 extra
  * fraction bits and holds the rounding constant and half of the line's own error (r is concave), so that the
  * total error is at most 0.85 units, or 1 at the very end. r(0) = 0 exactly, whence w = 1 and powers of two
  * are exact.
  */
object ReciprocalTable {
  val IndexBits = 8
  val FractionBits = 12
  val BaseBits = 19
  val SlopeBits = 13

  private val size = 1 << IndexBits
  private def exact(f: Double): Double = 65536 * 2 * f / (1 + f)

  val slope: Array[Int] = Array.tabulate(size) { i =>
    scala.math.round(16 * (exact((i + 1.0) / size) - exact(i.toDouble / size))).toInt
  }

  val base: Array[Int] = Array.tabulate(size) { i =>
    val from = exact(i.toDouble / size)
    val lineError = exact((i + 0.5) / size) - (from + exact((i + 1.0) / size)) / 2
    scala.math.round(8 * (from + lineError / 2 + 0.5) + 0.25).toInt
  }

  /** The table in one memory of 32 bits, the base above the slope. */
  def lines: Seq[Long] = (0 until size).map(i => base(i).toLong << SlopeBits | slope(i))

  /** The table in two memories of 16 bits. */
  def slopeWords: Seq[Int] = (0 until size).map(i => (base(i) & 7) << SlopeBits | slope(i))
  def baseWords: Seq[Int] = base.toSeq.map(_ >> 3)

  /** r in units of 2^-16; `fraction` is the top 20 bits of f. */
  def apply(fraction: Int): Int = {
    val i = fraction >>> FractionBits
    ((base(i) << 13) + slope(i) * (fraction & ((1 << FractionBits) - 1))) >>> 16
  }

  // The last interval ends at 1, which does not fit: its line is flattened until it stays below.
  private def end(i: Int): Long = (base(i).toLong << 13) + slope(i).toLong * ((1 << FractionBits) - 1)
  while (end(size - 1) >> 32 != 0) slope(size - 1) -= 1

  require(apply(0) == 0, s"the reciprocal of 1 is not exact: r(0) = ${apply(0)}")
  require(base.forall(b => b >= 0 && b >> BaseBits == 0), "a base of the reciprocal table does not fit")
  require(slope.forall(s => s >= 0 && s >> SlopeBits == 0), "a slope of the reciprocal table does not fit")
}
