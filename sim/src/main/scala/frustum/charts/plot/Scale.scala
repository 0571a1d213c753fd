package frustum.charts.plot

import scala.math.{ceil, floor, log10, pow}

/** One axis: values to places 0..1, and the values that are written beside it.
  *
  * @param low,high ends, in the axis' unit; above 0 on a logarithmic axis
  * @param zero     a logarithmic axis has a row of its own for 0, below its lower end
  */
final case class Scale(low: Double, high: Double, log: Boolean, zero: Boolean = false) {
  require(low < high && (!log || low > 0), s"an axis from $low to $high")
  private val start = if (zero) Scale.ZeroRow else 0.0

  def apply(v: Double): Double =
    if (!log) (v - low) / (high - low)
    else if (v <= 0) Scale.ZeroRow / 2
    else start + (1 - start) * (log10(v / low) / log10(high / low))

  /** What is written where, ascending: at least three numbers, at most ten. */
  def ticks: Seq[(Double, String)] = {
    val values =
      if (!log) Scale.steps(low, high, 4)
      else if (high / low < 20) Scale.steps(low, high, 4)
      else Scale.decades(low, high)
    Option.when(log && zero)(0.0 -> "none").toSeq ++ values.map(v => v -> Scale.text(v))
  }
}

object Scale {

  /** Share of a logarithmic axis that belongs to 0. */
  val ZeroRow = 0.1
  private val Most = 10

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

  /** Multiples of 1, 2 or 5 times a power of ten: the coarsest of which at least `least` lie between the ends. */
  private def steps(low: Double, high: Double, least: Int): Seq[Double] = {
    val power = floor(log10(high - low)).toInt
    val sizes = for (p <- power to power - 2 by -1; m <- Seq(5, 2, 1)) yield m * pow(10, p)
    def multiples(step: Double) = ceil(low / step - 1e-9).toLong to floor(high / step + 1e-9).toLong
    val step = sizes.find(multiples(_).length >= least).get
    multiples(step).map(n => tidy(n * step))
  }

  /** Powers of ten; where these are few 2 and 5 times them as well, where they are many some of them. */
  private def decades(low: Double, high: Double): Seq[Double] = {
    val exponents = floor(log10(low)).toInt to ceil(log10(high)).toInt
    def within(mantissas: Seq[Double]) =
      for (e <- exponents; m <- mantissas; v = tidy(m * pow(10, e)) if v >= low * 0.999 && v <= high * 1.001) yield v
    val fine = within(Seq(1, 2, 5))
    if (fine.length <= Most) fine
    else {
      val tens = within(Seq(1))
      val every = (tens.length + Most - 1) / Most
      tens.zipWithIndex.collect { case (v, i) if i % every == 0 => v }
    }
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
