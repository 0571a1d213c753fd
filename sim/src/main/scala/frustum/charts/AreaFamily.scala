package frustum.charts

import frustum.synthesis.UnitCosts
import scala.math.{floor, pow, round}

/** Reciprocal of a triangle's area, normalised to 1/2..1: Newton and Raphson's steps from a line or a table, 30
  * fraction bits as set-up has them.
  */
object AreaFamily extends ChartFamily {
  val name = "area"

  private val Places = 4001
  private def word(value: Double, bits: Int) = round(value * pow(2, bits)) / pow(2, bits)
  private def line(d: Double) = 48.0 / 17 - 32.0 / 17 * d
  private def table(bits: Int)(d: Double) =
    word(1 / ((floor(2 * d * pow(2, bits)) + 0.5) / pow(2, bits) / 2), bits + 3)

  /** Greatest |x d - 1| after so many steps x + x (1 - d x). */
  def error(guess: Double => Double, steps: Int): Double = (0 until Places).map { i =>
    val d = 0.5 + 0.5 * i / Places
    val x = (0 until steps).foldLeft(word(guess(d), 30))((x, _) => word(x + x * word(1 - d * x, 30), 30))
    (x * d - 1).abs
  }.max

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val lines = for (steps <- 0 to 4)
      yield ChartPoint("from a line", s"$steps steps", 1 + 2 * steps, error(line, steps))
    val tables = for (bits <- Seq(4, 8); steps <- 0 to 3)
      yield ChartPoint(s"from a table of 2^$bits", s"$steps steps", 2 * steps, error(table(bits), steps))
    Seq(Chart(
      "area-reciprocal",
      "Reciprocal of the area",
      "products, one after the other",
      "greatest relative error",
      lines ++ tables,
      lines.find(_.setting == "3 steps"),
      None,
      1e-10,
      "Each step squares the error, until the 30 fraction bits end it. A product is two clocks of the set-up engine; " +
        "a table saves a step or two and costs memory and a normalised index."
    ))
  }
}
