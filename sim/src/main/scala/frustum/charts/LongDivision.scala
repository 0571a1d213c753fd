package frustum.charts

import spinal.core._

/** s / q by long division, two numerators to a denominator, one pair a clock: what the perspective divide would be
  * without a table and multipliers. It is here to be charted against [[frustum.raster.texture.PerspectiveDivide]],
  * whose formats it takes.
  *
  * A row for each bit of the quotient: the doubled remainder less q, if that is not negative. |s| < q; the quotient,
  * |s| 2^8 / q in repeats, has 8 integer bits and is cut towards 0. Latency: a clock a row and one more.
  *
  * @param fraction bits of the quotient after the point
  */
final class LongDivision(fraction: Int) extends Component {
  val rows = 8 + fraction
  val io = new Bundle {
    val s, t = in SInt (32 bits)
    val q = in UInt (31 bits)
    val sq, tq = out SInt (rows + 1 bits)
  }
  private val denominators = Seq.iterate(RegNext(io.q), rows)(RegNext(_))

  private def quotient(s: SInt): SInt = {
    val (_, digits, negative) =
      denominators.foldLeft((RegNext(s.abs.resize(31)), Option.empty[UInt], RegNext(s.msb))) {
        case ((remainder, digits, negative), q) =>
          val doubled = remainder @@ False
          val less = doubled -^ q
          val bit = !less.msb
          val next = RegNext(bit ? less.resize(31) | doubled.resize(31))
          (next, Some(RegNext(digits.fold(bit.asUInt(1 bit))(_ @@ bit))), RegNext(negative))
      }
    val magnitude = digits.get.resize(rows + 1).asSInt
    negative ? (-magnitude) | magnitude
  }
  io.sq := quotient(io.s)
  io.tq := quotient(io.t)
}

object LongDivision {

  /** What it gives, in units of 2^-fraction. */
  def apply(s: Int, q: Int, fraction: Int): Long =
    (s.toLong.abs << 8 + fraction) / q * Integer.signum(s)
}
