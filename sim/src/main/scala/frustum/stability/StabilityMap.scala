package frustum.stability

import frustum.files.OutputFile
import org.knowm.xchart.BitmapEncoder.BitmapFormat
import org.knowm.xchart.style.markers.SeriesMarkers
import org.knowm.xchart.{AnnotationText, BitmapEncoder, XYChart, XYChartBuilder}
import java.awt.{BasicStroke, Color}
import java.nio.file.{Files, Path}

/** All sweeps as bars, one under the other, each along its own range. */
object StabilityMap {
  val HowToRead: String =
    "Each bar runs through one quantity, evenly by its logarithm (or evenly where it is a whole number): green " +
      "within the method's bound, yellow beyond it and of use, red broken, grey refused. The black line below a bar " +
      "is the declared domain, the blue one where compared systems work."

  private val colors = Map[Stability, Color](
    Stability.Safe -> new Color(0x4caf6d),
    Stability.Degraded -> new Color(0xf2c14e),
    Stability.Broken -> new Color(0xd64545),
    Stability.Refused -> new Color(0xb8bcc4)
  )

  def write(file: Path, results: Seq[SweepResult]): Unit = OutputFile.write(file) { part =>
    Files.write(part, BitmapEncoder.getBitmapBytes(picture(results), BitmapFormat.PNG))
  }

  private def picture(results: Seq[SweepResult]): XYChart = {
    val chart =
      new XYChartBuilder().width(1100).height(120 + 34 * results.length).title("Where methods fail").build()
    val style = chart.getStyler
    style.setAxisTicksVisible(false).setPlotGridLinesVisible(false).setLegendVisible(false)
    style.setYAxisMin(-0.6).setYAxisMax(results.length - 0.4).setXAxisMin(-0.18).setXAxisMax(1.01)
    def line(name: String, y: Double, from: Double, to: Double, color: Color, width: Float): Unit = {
      val series = chart.addSeries(name, Array(from, to), Array(y, y))
      series.setMarker(SeriesMarkers.NONE).setLineColor(color)
      series.setLineStyle(new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL))
    }
    for ((r, i) <- results.zipWithIndex) {
      val y = results.length - 1.0 - i
      def at(v: Double) = place(r.sweep, v)
      for (((a, b, state), n) <- r.stretches.zipWithIndex) line(s"$i.$n", y, at(a), at(b), colors(state), 14)
      chart.addAnnotation(new AnnotationText(r.sweep.name, -0.09, y, false))
      def range(name: String, low: Double, high: Double, below: Double, color: Color): Unit = {
        val (a, b) = (at(low), at(high))
        line(s"$i $name", y - below, a.min(b - 0.004), b, color, 3)
      }
      range("declared", r.sweep.domain.low, r.sweep.domain.high, 0.3, Color.BLACK)
      for (peer <- r.sweep.peer; (low, high) <- peer.range) range("peer", low, high, 0.4, new Color(0x2b6cb0))
      // Of borders that lie close together one is named.
      r.borders.foldLeft(Double.NegativeInfinity) { (last, b) =>
        val place = at(b.value)
        if (place - last < 0.05) last
        else { chart.addAnnotation(new AnnotationText(shortest(b.value), place, y, false)); place }
      }
    }
    chart
  }

  /** Three digits. */
  def shortest(v: Double): String =
    BigDecimal(v).round(new java.math.MathContext(3)).bigDecimal.stripTrailingZeros match {
      case d if v.abs >= 1e-3 && v.abs < 1e5 => d.toPlainString
      case d                                 => d.toString
    }

  /** 0 to 1 along a sweep. */
  private def place(s: Sweep, v: Double): Double = {
    def clip(x: Double) = x.max(0).min(1)
    if (s.whole) clip((v - s.from) / (s.to - s.from))
    else clip(scala.math.log(v / s.from) / scala.math.log(s.to / s.from))
  }
}
