package frustum.budgets

/** What a measured figure may be at worst.
  *
  * @param metric name of the figure; those that end in `psnr` are better when higher, all others when lower
  * @param bound,today infinite where a picture equals its reference
  */
final case class Budget(scene: String, metric: String, bound: Double, today: Double) {
  val higherIsBetter: Boolean = metric.endsWith("psnr")
  private def worse(a: Double, b: Double) = if (higherIsBetter) a < b else a > b

  def met: Boolean = !worse(today, bound)

  /** With a new value, the bound as it was. */
  def measured(value: Double): Budget = copy(today = value)

  /** The bound moved to today's value if that is better, rounded to what a person would write, on the safe side. */
  def tightened: Budget = if (scene == Budget.AnyPicture) this
  else {
    val candidate = Budget.rounded(today, up = !higherIsBetter)
    if (worse(candidate, bound)) this else copy(bound = candidate)
  }
  override def toString = s"$scene: $metric is $today, its bound $bound"
}

object Budget {

  /** In place of a scene: bounds for whatever is drawn, which those pictures that are measured do not tighten. */
  val AnyPicture = "any picture"

  /** A figure that has no bound yet takes today's. */
  def first(scene: String, metric: String, value: Double): Budget = {
    val loosest = if (metric.endsWith("psnr")) Double.NegativeInfinity else Double.PositiveInfinity
    Budget(scene, metric, loosest, value).tightened
  }

  /** To five significant digits; whole numbers as they are. */
  private def rounded(value: Double, up: Boolean): Double =
    if (value.isInfinite || value == scala.math.rint(value)) value
    else BigDecimal(value)
      .round(new java.math.MathContext(
        5,
        if (up) java.math.RoundingMode.CEILING else java.math.RoundingMode.FLOOR
      ))
      .toDouble
}
