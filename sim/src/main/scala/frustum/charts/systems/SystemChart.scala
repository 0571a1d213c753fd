package frustum.charts.systems

import frustum.charts.plot.{LegendLine, Panel, ParetoFront, Plot, PlotDrawing, PlotPoint, PlotRange, Scale}
import frustum.files.OutputFile
import java.nio.file.Path
import scala.math.sqrt

/** Whole systems: speed against errors, and logic cells against errors.
  *
  * @param cellsTitle of the picture with logic cells in place of speed; None where there is to be none
  * @param speedAxis  with its unit; more is better
  * @param errorAxes  with their units, a panel each; less is better
  * @param errorFloor errors below this count as none
  * @param peers      what others measured
  * @param note       how to read it
  */
final case class SystemChart(
    name: String,
    title: String,
    speedAxis: String,
    errorAxes: Seq[String],
    points: Seq[SystemPoint],
    peers: Seq[PeerPoint],
    note: String,
    errorFloor: Double = 1e-9,
    panelHeight: Int = 360,
    cellsTitle: Option[String] = None
) {
  private val numbered = points.zipWithIndex.map { case (p, i) => p -> s"${i + 1}" }
  private val groups = points.map(_.group).distinct

  /** What competes: hardware with a placed clock; where there is none, all that can be built. */
  private val rivals: Seq[SystemPoint] = {
    val built = points.filter(_.built)
    if (built.exists(_.placed)) built.filter(_.placed) else built
  }

  private def errorOf(axis: Int)(p: SystemPoint): Double = p.errors(axis).get
  private def shown(axis: Int, of: Seq[SystemPoint]) = of.filter(_.errors(axis).isDefined)

  /** What no other beats in speed and in an error. */
  def front(axis: Int): Seq[SystemPoint] = ParetoFront(shown(axis, rivals))(-_.speed, errorOf(axis)(_))

  /** What no other beats in logic cells and in an error. */
  def cellsFront(axis: Int): Seq[SystemPoint] =
    ParetoFront(shown(axis, points.filter(p => p.built && p.cells.isDefined)))(_.cells.get.toDouble, errorOf(axis)(_))

  def speedPlot: Plot = plot(
    title,
    speedAxis,
    points,
    _.speed,
    front,
    _.speed,
    hollow = !_.placed,
    "Grey: the Pareto front, what nothing else beats in both." +: markNotes(points)
  )

  /** None where no size is known. */
  def cellsPlot: Option[Plot] = cellsTitle.filter(_ => points.exists(_.cells.isDefined)).map { heading =>
    val sized = points.filter(_.cells.isDefined)
    plot(
      heading,
      "logic cells of the iCE40UP5K, which has 5,280",
      sized,
      _.cells.get.toDouble,
      cellsFront,
      _.cells,
      hollow = !_.placed,
      Seq("Grey: the Pareto front, what nothing else beats in both.") ++
        Option.when(sized.exists(!_.placed))("Hollow: it does not fit the part, so it has no clock.") ++
        Option.when(points.length > sized.length)(
          s"${points.length - sized.length} more are not here: methods, and what has not been placed; --synthesis " +
            "places it."
        )
    )
  }

  private def markNotes(of: Seq[SystemPoint]): Seq[String] = {
    val targets = of.filterNot(_.placed).map(_.clockMHz).distinct.sorted.map(Scale.text)
    Option.when(of.exists(_.placed))(
      "Filled: the clock is the placed one" + (if (of.exists(_.cells.isDefined)) "; the area is its logic cells."
                                               else ".")
    ).toSeq ++
      Option.when(targets.nonEmpty)(
        s"Hollow: no placed clock is known; drawn with the clock aimed at, ${targets.mkString(", ")} MHz."
      ) ++ Option.when(of.exists(!_.built))("\u2217: a method without hardware in the library.")
  }

  private def plot(
      heading: String,
      xAxis: String,
      of: Seq[SystemPoint],
      x: SystemPoint => Double,
      frontOf: Int => Seq[SystemPoint],
      peerX: PeerPoint => Option[(Double, Double)],
      hollow: SystemPoint => Boolean,
      words: Seq[String]
  ): Plot = {
    val number = numbered.toMap
    val panels = errorAxes.indices.filter(axis => shown(axis, of).nonEmpty).map { axis =>
      val here = shown(axis, of)
      val ranges = peers.filter(p => peerX(p).isDefined || p.errors(axis).isDefined)
        .map(p => PlotRange(p.name, peerX(p), p.errors(axis)))
      def ends(r: Seq[Option[(Double, Double)]]) = r.flatten.flatMap { case (a, b) => Seq(a, b) }
      val xs = here.map(x) ++ ends(ranges.map(_.x))
      val ys = here.map(errorOf(axis)) ++ ends(ranges.map(_.y))
      Panel(
        xAxis,
        errorAxes(axis),
        Scale.over(xs, log = xs.min > 0 && xs.max > 6 * xs.min),
        Scale.over(ys, log = true, errorFloor),
        here.map(p => PlotPoint(p.group, x(p), errorOf(axis)(p), number(p), radius(p), hollow(p))),
        Seq(frontOf(axis).map(p => (x(p), errorOf(axis)(p)))),
        ranges
      )
    }
    Plot(heading, panels, legend(of) ++ (("" +: words) :+ note).map(LegendLine(_)), panelHeight)
  }

  /** A UP5K full to the last of its 5,280 logic cells is 10 pixels; without a known area a point is small. */
  private def radius(p: SystemPoint) = p.cells.fold(Plot.Radius)(c => 10 * sqrt(c / 5280.0).min(1.6))

  private def legend(of: Seq[SystemPoint]): Seq[LegendLine] =
    for (group <- groups; mine = numbered.filter { case (p, _) => p.group == group && of.contains(p) } if mine.nonEmpty)
      yield LegendLine(
        s"$group: " + mine.map { case (p, n) => s"[$n] ${p.setting}${if (p.built) "" else "\u2217"}" }.mkString(", "),
        Some(group)
      )

  private def frontsOf(p: SystemPoint) = errorAxes.indices.filter(front(_).contains(p))

  def csv: String = {
    val facts = points.flatMap(_.facts.map(_._1)).distinct
    val head = Seq("group", "setting", speedAxis) ++ errorAxes ++
      (Seq("clockMHz", "clockSource", "logicCells", "built", "front") ++ facts)
    val rows = points.map { p =>
      Seq(p.group, p.setting, p.speed.toString) ++ p.errors.map(_.mkString) ++
        Seq(p.clockMHz.toString, source(p), p.cells.mkString, p.built.toString, frontsOf(p).map(_ + 1).mkString(" ")) ++
        facts.map(f => p.facts.toMap.get(f).mkString)
    }
    (head +: rows).map(_.map(quoted).mkString(",")).mkString("", "\n", "\n")
  }
  private def quoted(s: String) = if (s.exists(",\"".contains(_))) "\"" + s.replace("\"", "\"\"") + "\"" else s
  private def source(p: SystemPoint) = if (p.placed) "placed" else "target"

  def json: ujson.Obj = ujson.Obj(
    "name" -> name,
    "speedAxis" -> speedAxis,
    "errorAxes" -> errorAxes,
    "points" -> points.map { p =>
      val point = ujson.Obj(
        "group" -> p.group,
        "setting" -> p.setting,
        "speed" -> p.speed,
        "clockMHz" -> p.clockMHz,
        "clockSource" -> source(p),
        "built" -> p.built,
        "errors" -> p.errors.map(_.fold[ujson.Value](ujson.Null)(ujson.Num(_))),
        "front" -> frontsOf(p).map(errorAxes)
      )
      p.cells.foreach(point("logicCells") = _)
      for ((fact, value) <- p.facts) point(fact) = value
      point
    },
    "peers" -> peers.map { p =>
      def range(r: Option[(Double, Double)]): ujson.Value = r.fold[ujson.Value](ujson.Null) { case (a, b) =>
        ujson.Arr(a, b)
      }
      ujson.Obj(
        "name" -> p.name,
        "speed" -> range(p.speed),
        "logicCells" -> range(p.cells),
        "errors" -> p.errors.map(range)
      )
    }
  )

  /** Names of the pictures. */
  def pictures: Seq[String] = name +: cellsPlot.map(_ => s"$name-cells").toSeq

  /** Writes the pictures, PNG and SVG, and the CSV. */
  def write(folder: Path): Unit = {
    OutputFile.writeText(folder.resolve(s"$name.csv"), csv)
    for ((picture, plot) <- pictures.zip(speedPlot +: cellsPlot.toSeq)) PlotDrawing.write(folder, picture, plot)
  }
}
