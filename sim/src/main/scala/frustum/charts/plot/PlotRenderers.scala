package frustum.charts.plot

import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer
import org.jfree.chart.util.ShapeUtils
import java.awt.geom.{Ellipse2D, Rectangle2D}
import java.awt.{BasicStroke, Color, Paint, Shape}
import scala.math.{Pi, sqrt}

/** How the points of a series look: a colour and a shape, of the same area for the same radius. */
object PlotShapes {
  def color(series: Int): Color = Plot.Colors(Math.floorMod(series, Plot.Colors.length))

  /** Around (0, 0). @param radius pixels, of the circle of the same area */
  def apply(series: Int, radius: Double): Shape = {
    val reach = (radius * sqrt(Pi / 2)).toFloat // of shapes that have twice its square as area
    Math.floorMod(series, 5) match {
      case 0 => circle(radius)
      case 1 => val half = radius * sqrt(Pi) / 2; new Rectangle2D.Double(-half, -half, 2 * half, 2 * half)
      case 2 => ShapeUtils.createUpTriangle(reach)
      case 3 => ShapeUtils.createDiamond(reach)
      case 4 => ShapeUtils.createDownTriangle(reach)
    }
  }
  def circle(radius: Double): Shape = new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius)
}

/** Points of their own size, filled or hollow.
  *
  * @param points by series
  */
final class PointRenderer(points: Seq[Seq[PlotPoint]], joined: Boolean) extends XYLineAndShapeRenderer(joined, true) {
  setUseFillPaint(true)
  setDefaultOutlineStroke(new BasicStroke(1.6f))
  setAutoPopulateSeriesOutlineStroke(false)
  setDefaultStroke(new BasicStroke(1.3f))
  setAutoPopulateSeriesStroke(false)

  override def getItemShape(series: Int, item: Int): Shape = PlotShapes(series, points(series)(item).radius)
  override def getItemPaint(series: Int, item: Int): Paint = PlotShapes.color(series)
  override def getItemFillPaint(series: Int, item: Int): Paint = {
    val c = PlotShapes.color(series)
    if (points(series)(item).hollow) new Color(255, 255, 255, 200) else new Color(c.getRed, c.getGreen, c.getBlue, 215)
  }
}

/** Broad grey lines. */
final class FrontRenderer extends XYLineAndShapeRenderer {
  setDrawSeriesLineAsPath(true)
  setDrawOutlines(false)
  setAutoPopulateSeriesStroke(false)
  setAutoPopulateSeriesPaint(false)
  setAutoPopulateSeriesShape(false)
  setDefaultStroke(new BasicStroke(7))
  setDefaultPaint(new Color(0, 0, 0, 45))
  setDefaultShape(PlotShapes.circle(9))
}

/** Red outlines of diamonds, and red crosses. */
final class MarkRenderer(marks: Seq[PlotMark]) extends XYLineAndShapeRenderer(false, true) {
  setDefaultShapesFilled(false)
  setAutoPopulateSeriesOutlineStroke(false)
  setDefaultOutlineStroke(new BasicStroke(2.2f))
  setAutoPopulateSeriesPaint(false)
  setDefaultPaint(Plot.Marked)
  override def getItemShape(series: Int, item: Int): Shape =
    if (marks(item).cross) ShapeUtils.createDiagonalCross(7, 0.3f) else ShapeUtils.createDiamond(7)
}
