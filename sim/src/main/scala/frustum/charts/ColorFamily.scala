package frustum.charts

import frustum.contract.video.ColorFormat
import frustum.model.video.OrderedDither
import frustum.synthesis.{UnitCost, UnitCosts}
import scala.math.sqrt

/** Colour depth with and without ordered dither, on a smooth ramp of all three channels. */
object ColorFamily extends ChartFamily {
  val name = "colour"

  private val (width, height) = (256, 64)
  private val formats = Seq(
    ColorFormat.Rgb332,
    ColorFormat.Rgb444,
    ColorFormat.Rgb565,
    ColorFormat("666", 6, 6, 6),
    ColorFormat.Rgb888
  )

  /** A value of n bits in 0..255. */
  private def shown(value: Int, bits: Int): Double = value * 255.0 / ((1 << bits) - 1)

  /** Root mean square of what the mean of 4 x 4 pixels is off by, which is what an eye sees that does not make out
    * pixels.
    */
  def error(format: ColorFormat, dither: Boolean): Double = {
    var (sum, n) = (0.0, 0)
    for ((bits, channel) <- format.channels.zipWithIndex; y <- 0 until height by 4; x <- 0 until width by 4) {
      val difference =
        (for (dy <- 0 to 3; dx <- 0 to 3) yield {
          val value = ((x + dx) * (channel + 2) / 4 + (y + dy) / 4).min(255)
          val code = if (dither) OrderedDither.channel(value, bits, x + dx, y + dy) else value >> 8 - bits
          shown(code, bits) - value
        }).sum / 16
      sum += difference * difference
      n += 1
    }
    sqrt(sum / n)
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    def points(cost: (ColorFormat, Boolean) => (Double, Option[UnitCost])) =
      for (dither <- Seq(true, false); format <- formats) yield {
        val (cells, unit) = cost(format, dither)
        ChartPoint(if (dither) "ordered dither" else "cut", format.name, cells, error(format, dither), unit)
      }
    def marked(points: Seq[ChartPoint], method: String, format: ColorFormat) =
      points.find(p => p.method == method && p.setting == format.name)
    val bits = points((format, _) => (format.bits.toDouble, None))
    val cells = costs.map { c =>
      def unit(format: ColorFormat) =
        c.timed(s"ordered dither to ${format.name}")(frustum.video.OrderedDither(format))
      points((format, dither) =>
        if (dither) { val u = unit(format); (u.luts.toDouble, Some(u)) }
        else (0.0, None)
      )
    }
    Chart(
      "colour-bits",
      "Colour depth",
      "bits a pixel",
      "rms error of 4 x 4 means, of 255",
      bits,
      marked(bits, "ordered dither", ColorFormat.Rgb444),
      marked(bits, "cut", ColorFormat.Rgb444),
      1e-2,
      "Shipped is pong's 444 with dither; the peers cut."
    ) +:
      cells.toSeq.map(p =>
        Chart(
          "colour-cells",
          "What dither costs",
          "LUT of an iCE40",
          "rms error of 4 x 4 means, of 255",
          p,
          marked(p, "ordered dither", ColorFormat.Rgb444),
          marked(p, "cut", ColorFormat.Rgb444),
          1e-2,
          "Synthesised with yosys, the unit alone."
        )
      )
  }
}
