package frustum.charts.plot

import java.awt.Color
import java.nio.file.Path

/** Draws plots, the legend at their right. */
object PlotDrawing {
  private val Title = 17.0
  private val Text = 12.5
  private val Top = 48
  private val LegendWidth = 296
  private val LegendLine = 17
  private val Below = 62 // under a panel, for its axis
  private val Grid = new Color(0xe4e6ea)
  private val Ink = new Color(0x222222)
  private val Front = new Color(0, 0, 0, 45)

  /** Writes `<name>.png` and `<name>.svg`. */
  def write(folder: Path, name: String, plot: Plot): Unit =
    CanvasFiles.write(folder, name, Plot.Width, heightOf(plot))(draw(plot, _))

  private def heightOf(plot: Plot): Int =
    (Top + plot.panels.length * plot.panelHeight).max(Top + wrapped(plot).map(_._2.length).sum * LegendLine + 40)

  /** Each line of the legend with the lines of text it takes. */
  private def wrapped(plot: Plot): Seq[(LegendLine, Seq[String])] = plot.legend.map { l =>
    l -> Canvas.wrapped(l.text, Text, LegendWidth - (if (l.series.isDefined) 30 else 8))
  }

  def draw(plot: Plot, canvas: Canvas): Unit = {
    canvas.text(14, 28, plot.title, Title, color = Ink, bold = true)
    for ((panel, i) <- plot.panels.zipWithIndex)
      new PanelDrawing(plot, panel, canvas, Top + i * plot.panelHeight, plot.panelHeight - Below).draw()
    val left = Plot.Width - LegendWidth
    wrapped(plot).foldLeft(Top + 14.0) { case (y, (line, words)) =>
      line.series.foreach(s => Markers(canvas, plot.series.indexOf(s), left + 12, y - 4, Plot.Radius + 0.5, hollow = false))
      for ((text, n) <- words.zipWithIndex)
        canvas.text(left + (if (line.series.isDefined) 26 else 4), y + n * LegendLine, text, Text, color = Ink)
      y + words.length * LegendLine + 3
    }
  }

  /** One panel: its frame's top, and its frame's height. */
  private final class PanelDrawing(plot: Plot, panel: Panel, canvas: Canvas, top: Int, height: Int) {
    private val yTicks = panel.yScale.ticks
    private val left = 40 + yTicks.map(t => Canvas.widthOf(t._2, Text)).maxOption.getOrElse(0.0)
    private val right = (Plot.Width - LegendWidth - 14).toDouble
    private val bottom = top + height.toDouble

    private def x(v: Double) = left + panel.xScale(v).max(0).min(1) * (right - left)
    private def y(v: Double) = bottom - panel.yScale(v).max(0).min(1) * height

    def draw(): Unit = {
      axes()
      panel.ranges.foreach(range)
      for (front <- panel.fronts if front.length > 1)
        canvas.polygon(front.map { case (a, b) => (x(a), y(b)) }, closed = false, 7, Front, None)
      for (front <- panel.fronts; (a, b) <- front) canvas.circle(x(a), y(b), 9, 0, Front, Some(Front))
      if (panel.joined)
        for ((series, points) <- panel.points.groupBy(_.series).toSeq.sortBy(_._1))
          canvas.polygon(
            points.sortBy(_.x).map(p => (x(p.x), y(p.y))),
            closed = false,
            1.3,
            Markers.color(plot.series.indexOf(series)),
            None
          )
      for (p <- panel.points.sortBy(-_.radius))
        Markers(canvas, plot.series.indexOf(p.series), x(p.x), y(p.y), p.radius, p.hollow)
      panel.marks.foreach(mark)
      labels()
    }

    private def axes(): Unit = {
      for ((v, text) <- panel.xScale.ticks) {
        canvas.line(x(v), top, x(v), bottom, 1, Grid)
        canvas.text(x(v), bottom + 17, text, Text, Anchor.Middle, Ink)
      }
      for ((v, text) <- yTicks) {
        canvas.line(left, y(v), right, y(v), 1, Grid)
        canvas.text(left - 6, y(v) + 4, text, Text, Anchor.End, Ink)
      }
      canvas.polygon(Seq((left, top.toDouble), (left, bottom), (right, bottom)), closed = false, 1.2, Ink, None)
      canvas.text((left + right) / 2, bottom + 38, panel.xAxis, Text, Anchor.Middle, Ink)
      canvas.text(18, top + height / 2.0, panel.yAxis, Text, Anchor.Middle, Ink, turned = true)
    }

    private def range(r: PlotRange): Unit = {
      val (x0, x1) = r.x.fold((left, right)) { case (a, b) => (x(a), x(b)) }
      val (y0, y1) = r.y.fold((top.toDouble, bottom)) { case (a, b) => (y(b), y(a)) }
      val (w, h) = ((x1 - x0).max(3), (y1 - y0).max(3))
      val m = Plot.Marked
      canvas.box(x0, y0, w, h, new Color(m.getRed, m.getGreen, m.getBlue, 60))
      if (r.x.isDefined) canvas.text((x0 + w + 4).min(right - Canvas.widthOf(r.name, Text)), y0 + 13, r.name, Text, color = m)
      else canvas.text(right - 4, y0 - 4, r.name, Text, Anchor.End, m)
    }

    private def mark(m: PlotMark): Unit = {
      val (cx, cy, r) = (x(m.x), y(m.y), 7.0)
      if (m.cross) {
        canvas.line(cx - r, cy - r, cx + r, cy + r, 2.5, Plot.Marked)
        canvas.line(cx - r, cy + r, cx + r, cy - r, 2.5, Plot.Marked)
      } else
        canvas.polygon(Seq((cx - r, cy), (cx, cy - r), (cx + r, cy), (cx, cy + r)), closed = true, 2.2, Plot.Marked, None)
    }

    private def labels(): Unit = {
      def width(text: String) = Canvas.widthOf(text, Text)
      val each = for (p <- panel.points if p.label.nonEmpty)
        yield Labelled(x(p.x), y(p.y), p.radius, p.label, width(p.label), Text)
      val joined = LabelPlacement.joined(each, 6, width)
      val marks = panel.marks.map(m => Frame(x(m.x) - 8, y(m.y) - 8, x(m.x) + 8, y(m.y) + 8))
      val places = LabelPlacement(joined, Frame(left + 2, top - 6, right, bottom - 1), marks)
      for ((label, Some(f)) <- joined.zip(places)) {
        val (cx, cy) = ((f.x0 + f.x1) / 2, (f.y0 + f.y1) / 2)
        val (dx, dy) = ((label.x - cx).abs - label.width / 2, (label.y - cy).abs - label.height / 2)
        if (dx.max(dy) > label.radius + 8) canvas.line(label.x, label.y, label.x.max(f.x0).min(f.x1), cy, 0.8, Ink)
        canvas.text(f.x0, f.y1 - 2.5, label.text, Text, color = Ink)
      }
    }
  }
}
