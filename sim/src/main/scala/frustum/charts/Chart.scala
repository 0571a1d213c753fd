package frustum.charts

import frustum.charts.plot.{LegendLine, Panel, ParetoFront, Plot, PlotDrawing, PlotMark, PlotPoint, Scale}
import frustum.files.OutputFile
import frustum.synthesis.UnitCost
import java.nio.file.Path

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
  * @param floor errors below this count as none
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
    rivals.map(ParetoFront(_)(_.cost, _.error))
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

  /** Writes `<name>.png`, `<name>.svg` and `<name>.csv`. */
  def write(folder: Path): Unit = {
    OutputFile.writeText(folder.resolve(s"$name.csv"), csv)
    PlotDrawing.write(folder, name, plot)
  }

  def plot: Plot = {
    def mark(p: Option[ChartPoint], cross: Boolean) = p.map(m => PlotMark("", m.cost, m.error, cross)).toSeq
    val words = Seq(
      shipped.map(p => s"Red diamond: the library's default, ${p.setting}."),
      peer.map(p => s"Red cross: what the compared systems do${if (p.setting.isEmpty) "" else s", ${p.setting}"}."),
      Some(if (scenes) "Grey: the Pareto front of each scene."
      else "Grey: the Pareto front, what nothing beats in both.")
    ).flatten
    val panel = Panel(
      costAxis,
      errorAxis,
      Scale.over((points ++ peer).map(_.cost), logCost),
      Scale.over((points ++ peer).map(_.error), log = true, floor),
      points.map(p =>
        PlotPoint(
          p.method,
          p.cost,
          shown(p.error),
          p.hardware.flatMap(_.clockMHz).fold("")(mhz => f"$mhz%.0f MHz")
        )
      ),
      fronts.map(_.map(p => (p.cost, shown(p.error)))),
      marks = mark(shipped, cross = false) ++ mark(peer, cross = true),
      joined = true
    )
    Plot(
      title,
      Seq(panel),
      methods.map(m => LegendLine(m, Some(m))) ++ ("" +: words).map(LegendLine(_)),
      panelHeight = 540
    )
  }

  private def shown(error: Double) = if (error < floor) 0 else error
}
