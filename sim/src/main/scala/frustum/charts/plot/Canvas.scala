package frustum.charts.plot

import java.awt.image.BufferedImage
import java.awt.{Color, Font}

/** Where a text stands from its place: right of it, around it, left of it. */
sealed abstract class Anchor(val share: Double, val svg: String)
object Anchor {
  case object Start extends Anchor(0, "start")
  case object Middle extends Anchor(0.5, "middle")
  case object End extends Anchor(1, "end")
}

/** What the charts are drawn on; y grows downwards, lengths in pixels. */
trait Canvas {
  def width: Int
  def height: Int

  /** @param stroke width of the outline, 0 for none */
  def polygon(points: Seq[(Double, Double)], closed: Boolean, stroke: Double, line: Color, fill: Option[Color]): Unit
  def circle(x: Double, y: Double, radius: Double, stroke: Double, line: Color, fill: Option[Color]): Unit

  /** @param turned reads from below upwards */
  def text(
      x: Double,
      y: Double,
      words: String,
      size: Double,
      anchor: Anchor = Anchor.Start,
      color: Color = Color.BLACK,
      bold: Boolean = false,
      turned: Boolean = false
  ): Unit

  final def line(x0: Double, y0: Double, x1: Double, y1: Double, stroke: Double, color: Color): Unit =
    polygon(Seq((x0, y0), (x1, y1)), closed = false, stroke, color, None)
  final def box(x: Double, y: Double, w: Double, h: Double, fill: Color): Unit =
    polygon(Seq((x, y), (x + w, y), (x + w, y + h), (x, y + h)), closed = true, 0, fill, Some(fill))
}

object Canvas {
  private[plot] def font(size: Double, bold: Boolean): Font =
    new Font(Font.SANS_SERIF, if (bold) Font.BOLD else Font.PLAIN, 12).deriveFont(size.toFloat)
  private lazy val ruler = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics()

  /** Pixels that a text takes. */
  def widthOf(words: String, size: Double, bold: Boolean = false): Double = synchronized {
    ruler.getFontMetrics(font(size, bold)).stringWidth(words).toDouble
  }

  /** The lines that a text takes where there is room for so many pixels, broken at blanks. */
  def wrapped(words: String, size: Double, room: Double): Seq[String] =
    words.split(' ').foldLeft(Vector("")) { (lines, word) =>
      val longer = s"${lines.last} $word".trim
      if (lines.last.isEmpty || widthOf(longer, size) <= room) lines.init :+ longer else lines :+ word
    }
}
