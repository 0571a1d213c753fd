package frustum.charts

import frustum.files.OutputFile
import frustum.synthesis.UnitCost
import org.knowm.xchart.BitmapEncoder.BitmapFormat
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle
import org.knowm.xchart.style.markers.SeriesMarkers
import org.knowm.xchart.{AnnotationText, BitmapEncoder, XYChart, XYChartBuilder}
import java.nio.file.{Files, Path}

/** A method at one setting.
  *
  * @param method the line it belongs to
  * @param setting what tells it from the others on the line
  * @param cost,error in the units of the chart's axes; less is better
  * @param hardware what synthesis makes of it, and its clock, where that was wanted
  */
final case class ChartPoint(
    method: String,
    setting: String,
    cost: Double,
    error: Double,
    hardware: Option[UnitCost] = None
)

/** Error against cost.
  *
  * @param shipped the library's default, @param peer what the systems it is compared with do
  * @param floor errors below this are drawn at it: a logarithmic axis has no 0
  * @param note how to read it
  * @param scenes whether the lines are scenes, which do not compete: each has a front of its own
  */
final case class Chart(
    name: String,
    title: String,
    costAxis: String,
    errorAxis: String,
    points: Seq[ChartPoint],
    shipped: Option[ChartPoint],
    peer: Option[ChartPoint],
    floor: Double,
    note: String,
    logCost: Boolean = false,
    scenes: Boolean = false
) {
  private val methods = points.map(_.method).distinct

  /** Those that no other beats in both, by rising cost. */
  def fronts: Seq[Seq[ChartPoint]] = {
    val rivals = if (scenes) methods.map(m => points.filter(_.method == m)) else Seq(points)
    rivals.map(all =>
      all.filterNot(p =>
        all.exists(o => o.cost <= p.cost && o.error <= p.error && (o.cost < p.cost || o.error < p.error))
      ).sortBy(_.cost)
    )
  }
  def front: Seq[ChartPoint] = fronts.flatten

  def csv: String = {
    val rows = points.map { p =>
      val marks =
        Seq(shipped.contains(p) -> "shipped", peer.contains(p) -> "peer", front.contains(p) -> "front")
      Seq(
        p.method,
        p.setting,
        p.cost.toString,
        p.error.toString,
        marks.filter(_._1).map(_._2).mkString(" "),
        p.hardware.fold(",,,,")(_.figures.map(_._2.fold("")(v => BigDecimal(v).toString)).mkString(","))
      ).mkString(",")
    }
    val head = s"method,setting,$costAxis,$errorAxis,marks,${UnitCost.names.mkString(",")}"
    (head +: rows).mkString("", "\n", "\n")
  }

  /** Writes `<name>.png` and `<name>.csv`. */
  def write(folder: Path): Unit = {
    OutputFile.writeText(folder.resolve(s"$name.csv"), csv)
    OutputFile.write(folder.resolve(s"$name.png")) { part =>
      Files.write(part, BitmapEncoder.getBitmapBytes(picture, BitmapFormat.PNG))
    }
  }

  private def picture: XYChart = {
    val chart =
      new XYChartBuilder().width(
        960
      ).height(600).title(title).xAxisTitle(costAxis).yAxisTitle(errorAxis).build()
    chart.getStyler.setYAxisLogarithmic(true).setXAxisLogarithmic(logCost)
    def add(name: String, shown: Seq[ChartPoint]) =
      chart.addSeries(name, shown.map(_.cost).toArray, shown.map(_.error.max(floor)).toArray)
    for (method <- methods)
      add(method, points.filter(_.method == method).sortBy(_.cost))
    for ((front, n) <- fronts.zipWithIndex)
      add(if (n == 0) "Pareto front" else s"front $n", front).setMarker(SeriesMarkers.NONE).setLineWidth(6)
        .setLineColor(new java.awt.Color(0, 0, 0, 40)).setShowInLegend(n == 0)
    for (
      (what, point, marker) <-
        Seq(("shipped", shipped, SeriesMarkers.DIAMOND), ("the peers'", peer, SeriesMarkers.CROSS));
      p <- point
    ) {
      val series = add(what, Seq(p))
      series.setMarker(marker).setMarkerColor(java.awt.Color.RED)
      series.setXYSeriesRenderStyle(XYSeriesRenderStyle.Scatter)
    }
    val drawn = points.map(_.error.max(floor))
    val above = math.pow(drawn.max / drawn.min, 0.03) // so much of the axis lies between a point and its clock
    for (p <- points; mhz <- p.hardware.flatMap(_.clockMHz))
      chart.addAnnotation(new AnnotationText(f"$mhz%.0f MHz", p.cost, p.error.max(floor) * above, false))
    chart.getStyler.setMarkerSize(9)
    chart
  }
}
