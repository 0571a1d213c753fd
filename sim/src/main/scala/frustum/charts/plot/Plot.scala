package frustum.charts.plot

import java.awt.Color

/** A point of a plot.
  *
  * @param series what it belongs to: its colour, its shape and its line of the legend
  * @param label  short text beside it, or none
  * @param radius pixels
  * @param hollow drawn as an outline
  */
final case class PlotPoint(
    series: String,
    x: Double,
    y: Double,
    label: String = "",
    radius: Double = Plot.Radius,
    hollow: Boolean = false
)

/** A measured range that is marked by its name; along an axis of which nothing is known it reaches from end to end. */
final case class PlotRange(name: String, x: Option[(Double, Double)], y: Option[(Double, Double)])

/** A point that is marked: a diamond, or a cross. */
final case class PlotMark(name: String, x: Double, y: Double, cross: Boolean)

/** Two axes and what lies between them.
  *
  * @param fronts points joined by a broad grey line
  * @param joined whether the points of a series are joined
  */
final case class Panel(
    xAxis: String,
    yAxis: String,
    xScale: Scale,
    yScale: Scale,
    points: Seq[PlotPoint],
    fronts: Seq[Seq[(Double, Double)]] = Nil,
    ranges: Seq[PlotRange] = Nil,
    marks: Seq[PlotMark] = Nil,
    joined: Boolean = false
)

/** A line of the legend.
  *
  * @param series the one that it explains; None: words alone
  */
final case class LegendLine(text: String, series: Option[String] = None)

/** A picture of one or more panels, one below the other, with one legend at their right.
  *
  * @param panelHeight pixels
  */
final case class Plot(title: String, panels: Seq[Panel], legend: Seq[LegendLine], panelHeight: Int = 420) {

  /** In the order in which they come first. */
  val series: Seq[String] = (panels.flatMap(_.points.map(_.series)) ++ legend.flatMap(_.series)).distinct
}

object Plot {
  val Width = 960
  val Radius = 4.5

  /** Colours that people who see red and green alike tell apart (Okabe and Ito, "Color Universal Design", 2008). */
  val Colors: IndexedSeq[Color] =
    IndexedSeq(
      0x0072b2, 0xe69f00, 0x009e73, 0xcc79a7, 0x56b4e9, 0x8c6d1f, 0x6a3d9a, 0x444444, 0xb8a800
    ).map(new Color(_))

  /** Of what is marked. */
  val Marked = new Color(0xd62728)
}
