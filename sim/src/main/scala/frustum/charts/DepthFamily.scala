package frustum.charts

import frustum.synthesis.UnitCosts
import scala.math.{floor, log10, pow}

/** Depth formats: the least gap, relative to the depth, that two surfaces need to be told apart, at the worst depth
  * between near and far plane.
  */
object DepthFamily extends ChartFamily {
  val name = "depth"

  private val near = 1.0

  /** Encodings of depth w to a number; equal numbers are not told apart. */
  private def fixed(value: Double, bits: Int): Double = floor(value * (pow(2, bits) - 1) + 0.5)
  private def float(value: Double, bits: Int): Double = { // five bits of exponent
    val exponent = scala.math.max(scala.math.getExponent(value), -31)
    floor(value / pow(2, exponent) * pow(2, bits - 5)) * pow(2, exponent)
  }
  private val encodings: Seq[(String, (Double, Double, Int) => Double)] = Seq(
    "z of OpenGL, linear on the screen" -> ((w, far, bits) =>
      fixed((1 / near - 1 / w) / (1 / near - 1 / far), bits)
    ),
    "1/w, without regard to the far plane" -> ((w, _, bits) => fixed(near / w, bits)),
    "w, linear in space" -> ((w, far, bits) => fixed((w - near) / (far - near), bits)),
    "reversed float, 5 bits of exponent" -> ((w, far, bits) =>
      float((1 / w - 1 / far) / (1 / near - 1 / far), bits)
    )
  )

  /** The least relative gap that is always seen, by bisection, at the worst of depths spread evenly by their logarithm.
    */
  def gap(encode: (Double, Double, Int) => Double, far: Double, bits: Int): Double = {
    val Depths = 200
    (0 until Depths).map { i =>
      val w = near * pow(far / near, (i + 0.5) / Depths)
      val here = encode(w, far, bits)
      var (low, high) = (1e-9, far / w - 1)
      if (encode(w * (1 + high), far, bits) == here) high
      else {
        while (high / low > 1.01) {
          val middle = scala.math.sqrt(low * high)
          if (encode(w * (1 + middle), far, bits) == here) low = middle else high = middle
        }
        high
      }
    }.max
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val bits = for ((method, encode) <- encodings; bits <- 8 to 24 by 2)
      yield ChartPoint(method, s"$bits bits", bits, gap(encode, 100, bits))
    val ratio = for ((method, encode) <- encodings; decade <- 1 to 8) yield {
      val far = pow(10, decade / 2.0)
      ChartPoint(method, f"far ${log10(far)}%.1f decades", far, gap(encode, far, 16))
    }
    def ours(points: Seq[ChartPoint], cost: Double) =
      points.find(p => p.method == encodings.head._1 && p.cost == cost)
    Seq(
      Chart(
        "depth-bits",
        "Depth formats, far plane at 100 times the near one",
        "bits",
        "least relative gap told apart",
        bits,
        ours(bits, 16),
        ours(bits, 16),
        1e-9,
        "Ours and the peers' are both 16 bits of OpenGL's z."
      ),
      Chart(
        "depth-range",
        "Depth formats of 16 bits",
        "far / near",
        "least relative gap told apart",
        ratio,
        ours(ratio, 100),
        None,
        1e-9,
        "z of OpenGL wastes nearly all of its codes near the eye when the range is long.",
        logCost = true
      )
    )
  }
}
