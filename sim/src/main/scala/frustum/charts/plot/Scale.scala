package frustum.charts.plot

import scala.math.{floor, log10, pow}

/** One axis.
  *
  * @param low,high ends, in the axis' unit; above 0 on a logarithmic axis
  * @param zero     a logarithmic axis has a row of its own for 0, below its lower end
  */
final case class Scale(low: Double, high: Double, log: Boolean, zero: Boolean = false) {
  require(low < high && (!log || low > 0), s"an axis from $low to $high")

  /** So far below the lower end is this share of the whole axis. */
  private def below(share: Double) = low / pow(high / low, share / (1 - Scale.ZeroRow))

  /** Where 0 is drawn on a logarithmic axis, and where the axis begins. */
  val (zeroAt, start) = if (log && zero) (below(Scale.ZeroRow / 2), below(Scale.ZeroRow)) else (low, low)

  /** The value at whose place another one is drawn. */
  def drawn(v: Double): Double = if (v < low) zeroAt else v.min(high)
}

object Scale {

  /** Share of a logarithmic axis that belongs to 0. */
  val ZeroRow = 0.1

  /** Wide enough for all of these. On a logarithmic axis what is below `floor` counts as 0. */
  def over(values: Seq[Double], log: Boolean, floor: Double = 0): Scale =
    if (log) {
      val positive = values.filter(v => v > 0 && v >= floor)
      val zero = positive.length < values.length
      val (low, high) = if (positive.isEmpty) (0.01, 1.0) else (positive.min, positive.max)
      val room = pow(high / low, 0.06).max(1.1)
      Scale(low / room, high * room, log = true, zero)
    } else {
      val (low, high) = if (values.isEmpty) (0.0, 1.0) else (values.min, values.max)
      val room = if (high > low) 0.06 * (high - low) else low.abs.max(1) * 0.1
      Scale(if (low >= 0) (low - room).max(0).min(low) else low - room, high + room, log = false)
    }

  private def tidy(v: Double): Double = BigDecimal(v).round(new java.math.MathContext(9)).toDouble

  /** As a reader writes it: 0.05, 1,200, 3 x 10^-6 with raised digits. */
  def text(v: Double): String =
    if (v == 0) "0"
    else if (v.abs >= 1e-3 && v.abs < 1e7) {
      val plain = BigDecimal(tidy(v)).bigDecimal.stripTrailingZeros.toPlainString
      val (whole, fraction) = plain.span(_ != '.')
      "(\\d)(?=(\\d{3})+$)".r.replaceAllIn(whole, "$1,") + fraction
    } else {
      val exponent = floor(log10(v.abs) + 1e-9).toInt
      val mantissa = tidy(v / pow(10, exponent))
      val raised = exponent.toString.map(c => if (c == '-') '\u207b' else Raised(c - '0'))
      (if (mantissa == 1) "" else s"${text(mantissa)} \u00d7 ") + s"10$raised"
    }

  private val Raised = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"
}
