package frustum.charts.plot

import org.jfree.chart.annotations.AbstractXYAnnotation
import org.jfree.chart.axis.ValueAxis
import org.jfree.chart.plot.{PlotRenderingInfo, XYPlot}
import java.awt.geom.{Line2D, Rectangle2D}
import java.awt.{BasicStroke, Color, Font, Graphics2D}

/** The names of ranges and the labels of points, where there is room for them. */
final class PlotLabels(panel: Panel, font: Font, ink: Color) extends AbstractXYAnnotation {
  def draw(
      g: Graphics2D,
      plot: XYPlot,
      area: Rectangle2D,
      xAxis: ValueAxis,
      yAxis: ValueAxis,
      renderer: Int,
      info: PlotRenderingInfo
  ): Unit = {
    val metrics = g.getFontMetrics(font)
    def x(v: Double) = xAxis.valueToJava2D(panel.xScale.drawn(v), area, plot.getDomainAxisEdge)
    def y(v: Double) = yAxis.valueToJava2D(panel.yScale.drawn(v), area, plot.getRangeAxisEdge)
    def label(x: Double, y: Double, radius: Double, text: String) =
      Labelled(x, y, radius, text, metrics.stringWidth(text), font.getSize2D)

    val names = for (r <- panel.ranges)
      yield label(r.x.fold(area.getMaxX)(e => x(e._2)), r.y.fold(area.getMinY + 9)(e => y(e._2)), 0, r.name)
    val each = for (p <- panel.points if p.label.nonEmpty) yield label(x(p.x), y(p.y), p.radius, p.label)
    val all = names ++ LabelPlacement.joined(each, 6, metrics.stringWidth(_).toDouble)
    val marks = panel.marks.map(m => Frame(x(m.x) - 8, y(m.y) - 8, x(m.x) + 8, y(m.y) + 8))
    val within = Frame(area.getMinX + 2, area.getMinY + 1, area.getMaxX - 1, area.getMaxY - 1)
    g.setFont(font)
    g.setStroke(new BasicStroke(0.8f))
    for (((label, Some(f)), i) <- all.zip(LabelPlacement(all, within, marks)).zipWithIndex) {
      g.setColor(if (i < names.length) Plot.Marked else ink)
      val (cx, cy) = ((f.x0 + f.x1) / 2, (f.y0 + f.y1) / 2)
      val (dx, dy) = ((label.x - cx).abs - label.width / 2, (label.y - cy).abs - label.height / 2)
      if (dx.max(dy) > label.radius + 8) g.draw(new Line2D.Double(label.x, label.y, label.x.max(f.x0).min(f.x1), cy))
      g.drawString(label.text, f.x0.toFloat, f.y1.toFloat - 2.5f)
    }
  }
}
