package frustum.command.common

import java.util.Locale

/** Numbers as a person writes them. */
object Figure {

  /** Whole numbers with separators, others to so many significant digits, without zeros at the end. */
  def apply(v: Double, digits: Int = 4): String =
    if (v == scala.math.rint(v) && v.abs < 1e15) "%,d".formatLocal(Locale.ROOT, v.toLong)
    else {
      val rounded = BigDecimal(v).round(new java.math.MathContext(digits)).bigDecimal.stripTrailingZeros
      if (rounded.scale <= 0) "%,d".formatLocal(Locale.ROOT, rounded.longValue) else rounded.toPlainString
    }

  /** "fullScreenClocksPerPixel" as "full screen clocks per pixel": a name for what has no other. */
  def words(key: String): String =
    key.replaceAll("([a-z0-9])([A-Z])", "$1 $2").split(' ').map(w =>
      if (w.drop(1).exists(_.isUpper)) w else w.toLowerCase
    )
      .mkString(" ")
}
