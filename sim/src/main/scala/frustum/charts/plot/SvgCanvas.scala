package frustum.charts.plot

import java.awt.Color
import scala.collection.mutable

/** Writes SVG 1.1. */
final class SvgCanvas(val width: Int, val height: Int) extends Canvas {
  private val body = mutable.ArrayBuffer.empty[String]
  box(0, 0, width, height, Color.WHITE)

  def document: String =
    s"""<svg xmlns="http://www.w3.org/2000/svg" width="$width" height="$height" viewBox="0 0 $width $height"
       | font-family="DejaVu Sans, Verdana, sans-serif">
       |${body.mkString("\n")}
       |</svg>
       |""".stripMargin

  private def number(v: Double) =
    BigDecimal(v).setScale(2, BigDecimal.RoundingMode.HALF_UP).bigDecimal.stripTrailingZeros.toPlainString
  private def rgb(c: Color) = f"#${c.getRGB & 0xffffff}%06x"
  private def paint(stroke: Double, line: Color, fill: Option[Color]) = {
    def opacity(name: String, c: Color) =
      if (c.getAlpha == 255) "" else s""" $name-opacity="${number(c.getAlpha / 255.0)}""""
    val inside = fill.fold("""fill="none"""")(c => s"""fill="${rgb(c)}"${opacity("fill", c)}""")
    val outline =
      if (stroke == 0) "" else s""" stroke="${rgb(line)}" stroke-width="${number(stroke)}"${opacity("stroke", line)}"""
    inside + outline
  }
  def polygon(points: Seq[(Double, Double)], closed: Boolean, stroke: Double, line: Color, fill: Option[Color]): Unit = {
    val places = points.map { case (x, y) => s"${number(x)},${number(y)}" }.mkString(" ")
    body += s"""<${if (closed) "polygon" else "polyline"} points="$places" ${paint(stroke, line, fill)}/>"""
  }
  def circle(x: Double, y: Double, radius: Double, stroke: Double, line: Color, fill: Option[Color]): Unit =
    body += s"""<circle cx="${number(x)}" cy="${number(y)}" r="${number(radius)}" ${paint(stroke, line, fill)}/>"""
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
    val place = s"""x="${number(x)}" y="${number(y)}""""
    val turn = if (turned) s""" transform="rotate(-90 ${number(x)} ${number(y)})"""" else ""
    val weight = if (bold) """ font-weight="bold"""" else ""
    val plain = words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    val look = s"""font-size="${number(size)}" text-anchor="${anchor.svg}" fill="${rgb(color)}""""
    body += s"""<text $place $look$weight$turn>$plain</text>"""
  }
}
