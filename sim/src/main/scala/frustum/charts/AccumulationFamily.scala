package frustum.charts

import frustum.synthesis.UnitCosts
import scala.math.{pow, round}
import scala.util.Random

/** An attribute across the screen: one value to start with and a gradient added from pixel to pixel, against values
  * afresh at each tile. The gradient has f fraction bits; what it is off by adds up over as many pixels as it is used
  * for.
  */
object AccumulationFamily extends ChartFamily {
  val name = "accumulation"

  val Screen = 320
  private val Planes = 200

  /** Greatest error of a plane of slope below 1 over the screen, values afresh every so many pixels. */
  def error(fraction: Int, every: Int): Double = {
    val random = new Random(1)
    val one = pow(2, fraction)
    Seq.fill(Planes) {
      val (start, slope) = (random.nextDouble(), random.nextDouble())
      val step = round(slope * one)
      (0 until Screen).map { x =>
        val from = x / every * every
        ((round((start + slope * from) * one) + step * (x - from)) / one - (start + slope * x)).abs
      }.max
    }.max
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val lines =
      Seq(Screen -> "accumulated over 320 pixels") ++ Seq(32, 16, 8).map(n => n -> s"afresh every $n pixels")
    val points = for ((every, method) <- lines; fraction <- 4 to 24 by 4)
      yield ChartPoint(method, s"$fraction fraction bits", fraction, error(fraction, every))
    def at(every: Int) = points.find(p => p.method == lines.toMap.apply(every) && p.cost == 16)
    Seq(Chart(
      "accumulation",
      "Attributes by accumulation across the screen and afresh at each tile",
      "fraction bits",
      "greatest error, units of the attribute",
      points,
      at(16),
      at(Screen),
      1e-8,
      "Accumulation drifts by half a unit a pixel, 160 x 2^-f over a screen when gradients are rounded and 320 x " +
        "2^-f when they are cut; a tile of 16 keeps it to 8 and saves four bits of every adder and register. Marked " +
        "at 16 bits: our tiles, the peers' screen."
    ))
  }
}
