package frustum.charts.plot

import java.awt.geom.{Ellipse2D, Path2D}
import java.awt.image.BufferedImage
import java.awt.{BasicStroke, Color, Graphics2D, RenderingHints, Shape}

/** Draws on an image, white to begin with. */
final class PixelCanvas(val width: Int, val height: Int) extends Canvas {
  val image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
  private val g: Graphics2D = image.createGraphics()
  g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
  g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON)
  g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE)
  box(0, 0, width, height, Color.WHITE)

  private def shape(s: Shape, stroke: Double, line: Color, fill: Option[Color]): Unit = {
    fill.foreach { color => g.setColor(color); g.fill(s) }
    if (stroke > 0) {
      g.setColor(line)
      g.setStroke(new BasicStroke(stroke.toFloat, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND))
      g.draw(s)
    }
  }
  def polygon(points: Seq[(Double, Double)], closed: Boolean, stroke: Double, line: Color, fill: Option[Color]): Unit =
    shape(pathOf(points, closed), stroke, line, fill)
  def circle(x: Double, y: Double, radius: Double, stroke: Double, line: Color, fill: Option[Color]): Unit =
    shape(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius), stroke, line, fill)
  def text(
      x: Double,
      y: Double,
      words: String,
      size: Double,
      anchor: Anchor,
      color: Color,
      bold: Boolean,
      turned: Boolean
  ): Unit = {
    g.setColor(color)
    g.setFont(Canvas.font(size, bold))
    val (was, left) = (g.getTransform, -anchor.share * Canvas.widthOf(words, size, bold))
    g.translate(x, y)
    if (turned) g.rotate(-scala.math.Pi / 2)
    g.drawString(words, left.toFloat, 0f)
    g.setTransform(was)
  }

  private def pathOf(points: Seq[(Double, Double)], closed: Boolean): Path2D = {
    val path = new Path2D.Double
    points.headOption.foreach { case (x, y) => path.moveTo(x, y) }
    points.drop(1).foreach { case (x, y) => path.lineTo(x, y) }
    if (closed) path.closePath()
    path
  }
}
