package frustum.charts.plot

import org.jfree.chart.JFreeChart
import org.jfree.chart.annotations.XYBoxAnnotation
import org.jfree.chart.plot.{DatasetRenderingOrder, IntervalMarker, SeriesRenderingOrder, XYPlot}
import org.jfree.chart.renderer.xy.XYItemRenderer
import org.jfree.chart.text.{TextBlock, TextBlockAnchor}
import org.jfree.chart.ui.{Layer, RectangleInsets}
import org.jfree.data.xy.{XYSeries, XYSeriesCollection}
import java.awt.geom.{AffineTransform, Rectangle2D}
import java.awt.{BasicStroke, Color, Graphics2D}
import java.nio.file.Path

/** Draws plots with JFreeChart, the legend at their right. */
object PlotDrawing {
  private val Text = PictureFiles.font(12.5)
  private val Top = 48
  private val LegendWidth = 296
  private val LegendGap = 5
  private val Grid = new Color(0xe4e6ea)
  private val Ink = new Color(0x222222)
  private val Range = new Color(Plot.Marked.getRed, Plot.Marked.getGreen, Plot.Marked.getBlue, 60)

  /** Writes `<name>.png` and `<name>.svg`. */
  def write(folder: Path, name: String, plot: Plot): Unit = {
    val ruler = PictureFiles.ruler
    val legend = legendOf(plot, ruler).map { case (_, block) =>
      block.calculateDimensions(ruler).height + LegendGap
    }.sum
    val height = Top + (plot.panels.length * plot.panelHeight).max(legend.ceil.toInt + 20)
    PictureFiles.write(folder, name, Plot.Width, height)(draw(plot, _))
  }

  private def draw(plot: Plot, g: Graphics2D): Unit = {
    g.setFont(PictureFiles.font(17, bold = true))
    g.setColor(Ink)
    g.drawString(plot.title, 14, 28)
    val left = Plot.Width - LegendWidth
    for ((panel, i) <- plot.panels.zipWithIndex) {
      val chart = new JFreeChart(null, null, panelPlot(plot, panel), false)
      chart.setBackgroundPaint(Color.WHITE)
      chart.draw(g, new Rectangle2D.Double(0, Top + i * plot.panelHeight, left, plot.panelHeight))
    }
    legendOf(plot, g).foldLeft(Top + 4.0) { case (y, (line, block)) =>
      for (series <- line.series.map(plot.series.indexOf(_))) {
        g.setColor(PlotShapes.color(series))
        g.fill(AffineTransform.getTranslateInstance(left + 12, y + 8)
          .createTransformedShape(PlotShapes(series, Plot.Radius + 0.5)))
      }
      block.draw(g, (left + indent(line)).toFloat, y.toFloat, TextBlockAnchor.TOP_LEFT)
      y + block.calculateDimensions(g).height + LegendGap
    }
  }

  private def indent(line: LegendLine) = if (line.series.isDefined) 26 else 4

  /** The lines of the legend, each broken into as many as it takes. */
  private def legendOf(plot: Plot, g: Graphics2D): Seq[(LegendLine, TextBlock)] = plot.legend.map { l =>
    l -> PictureFiles.wrapped(l.text, Text, Ink, LegendWidth - 4 - indent(l), g)
  }

  private def panelPlot(plot: Plot, panel: Panel): XYPlot = {
    val xy = new XYPlot
    xy.setDomainAxis(PlotAxis(panel.xAxis, panel.xScale))
    xy.setRangeAxis(PlotAxis(panel.yAxis, panel.yScale))
    for (axis <- Seq(xy.getDomainAxis, xy.getRangeAxis)) {
      axis.setTickLabelFont(Text)
      axis.setLabelFont(Text)
      axis.setTickLabelPaint(Ink)
      axis.setLabelPaint(Ink)
      axis.setAxisLinePaint(Ink)
    }
    xy.setBackgroundPaint(Color.WHITE)
    xy.setOutlineVisible(false)
    xy.setInsets(new RectangleInsets(4, 10, 8, 16))
    xy.setDomainGridlinePaint(Grid)
    xy.setRangeGridlinePaint(Grid)
    xy.setDomainGridlineStroke(new BasicStroke(1))
    xy.setRangeGridlineStroke(new BasicStroke(1))
    panel.ranges.foreach(range(xy, panel, _))

    def layer(index: Int, renderer: XYItemRenderer, series: Seq[Seq[(Double, Double)]]): Unit = {
      val data = new XYSeriesCollection
      for ((points, i) <- series.zipWithIndex) {
        val one = new XYSeries(i, false)
        for ((x, y) <- points) one.add(panel.xScale.drawn(x), panel.yScale.drawn(y))
        data.addSeries(one)
      }
      xy.setDataset(index, data)
      xy.setRenderer(index, renderer)
    }
    // A line runs from left to right; without one the small points lie on the large.
    val points =
      plot.series.map(s => panel.points.filter(_.series == s).sortBy(p => if (panel.joined) p.x else -p.radius))
    layer(0, new FrontRenderer, panel.fronts)
    layer(1, new PointRenderer(points, panel.joined), points.map(_.map(p => (p.x, p.y))))
    layer(2, new MarkRenderer(panel.marks), Seq(panel.marks.map(m => (m.x, m.y))))
    xy.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD)
    xy.setSeriesRenderingOrder(SeriesRenderingOrder.FORWARD)
    xy.addAnnotation(new PlotLabels(panel, Text, Ink))
    xy
  }

  private def range(xy: XYPlot, panel: Panel, r: PlotRange): Unit = {
    val edge = new BasicStroke(2) // a range without a width is seen
    def marker(ends: (Double, Double), scale: Scale) =
      new IntervalMarker(scale.drawn(ends._1), scale.drawn(ends._2), Range, edge, Range, edge, 1)
    (r.x, r.y) match {
      case (Some((x0, x1)), Some((y0, y1))) =>
        val (x, y) = (panel.xScale.drawn _, panel.yScale.drawn _)
        xy.addAnnotation(new XYBoxAnnotation(x(x0), y(y0), x(x1), y(y1), edge, Range, Range))
      case (Some(x), None) => xy.addDomainMarker(marker(x, panel.xScale), Layer.BACKGROUND)
      case (None, Some(y)) => xy.addRangeMarker(marker(y, panel.yScale), Layer.BACKGROUND)
      case (None, None)    =>
    }
  }
}
