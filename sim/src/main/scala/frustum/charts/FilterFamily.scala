package frustum.charts

import frustum.synthesis.UnitCosts
import scala.math.{floor, pow, round}
import scala.util.Random

/** Bits of the weights of a bilinear filter, on texels that differ at random: what is lost of a channel. The weights
  * are a texel coordinate's upper fraction bits.
  */
object FilterFamily extends ChartFamily {
  val name = "filter"

  private val Samples = 20000

  private def mix(a: Double, b: Double, weight: Double) = a + (b - a) * weight

  /** Root mean square, of 255.
    *
    * @param weight what becomes of a fraction
    * @param result what becomes of the mixed channel, 0..255
    */
  private def error(weight: Double => Double, result: Double => Double): Double = {
    val random = new Random(1)
    val sum = Seq.fill(Samples) {
      val texels = Seq.fill(4)(random.nextInt(32) * 255.0 / 31)
      val (u, v) = (random.nextDouble(), random.nextDouble())
      def channel(u: Double, v: Double) =
        mix(mix(texels(0), texels(1), u), mix(texels(2), texels(3), u), v)
      pow(result(channel(weight(u), weight(v))) - channel(u, v), 2)
    }.sum
    scala.math.sqrt(sum / Samples)
  }

  private def cut(bits: Int)(f: Double) = floor(f * (1 << bits)) / (1 << bits)
  private def nearest(bits: Int)(f: Double) = round(f * (1 << bits)) / (1 << bits).toDouble
  private def exact(v: Double) = v
  private def fiveBits(v: Double) = round(v * 31 / 255) * 255.0 / 31

  def error(bits: Int, rounded: Boolean): Double =
    error(if (rounded) nearest(bits) _ else cut(bits) _, exact _)

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val points = for {
      (method, weight, result) <- Seq[(String, Int => Double => Double, Double => Double)](
        ("weights cut", cut, exact),
        ("weights to the nearest", nearest, exact),
        ("weights to the nearest, result of 5 bits", nearest, fiveBits)
      )
      bits <- 1 to 8
    } yield ChartPoint(method, s"$bits bits", bits, error(weight(bits), result))
    Seq(Chart(
      "filter-weights",
      "Bilinear filter: bits of the weights, texels of 5 bits that differ at random",
      "bits of a weight",
      "rms error of a channel, of 255",
      points,
      None,
      None,
      1e-2,
      "The method in float64, with no unit of the library behind it. With 4 bits the weights are off by less than " +
        "the 5 bits of the frame buffer are; cutting them costs a bit."
    ))
  }
}
