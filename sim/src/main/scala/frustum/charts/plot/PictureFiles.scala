package frustum.charts.plot

import frustum.files.OutputFile
import org.apache.batik.svggen.SVGGraphics2D
import org.jfree.chart.ChartUtils
import org.jfree.chart.text.{G2TextMeasurer, TextBlock, TextUtils}
import org.jfree.chart.ui.HorizontalAlignment
import java.awt.image.BufferedImage
import java.awt.{Color, Dimension, Font, Graphics2D, RenderingHints}
import java.io.StringWriter
import java.nio.file.{Files, Path}
import javax.xml.parsers.DocumentBuilderFactory

/** A drawing as two files: pixels for pages, and shapes and words that stay sharp at any size. */
object PictureFiles {

  /** @param size pixels */
  def font(size: Double, bold: Boolean = false): Font =
    new Font(Font.SANS_SERIF, if (bold) Font.BOLD else Font.PLAIN, 12).deriveFont(size.toFloat)

  /** To measure texts with before the size of a picture is known. */
  def ruler: Graphics2D = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics()

  /** A text broken at blanks into the lines that it takes. @param room pixels from left to right */
  def wrapped(words: String, font: Font, color: Color, room: Double, g: Graphics2D): TextBlock = {
    val block = TextUtils.createTextBlock(words, font, color, room.toFloat, new G2TextMeasurer(g))
    block.setLineAlignment(HorizontalAlignment.LEFT)
    block
  }

  /** Writes `<name>.png` and `<name>.svg`, white where nothing is drawn. */
  def write(folder: Path, name: String, width: Int, height: Int)(draw: Graphics2D => Unit): Unit = {
    def drawn[G <: Graphics2D](g: G): G = {
      g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
      g.setColor(Color.WHITE)
      g.fillRect(0, 0, width, height)
      draw(g)
      g
    }
    val shapes = DocumentBuilderFactory.newInstance.newDocumentBuilder.getDOMImplementation
    val svg = new SVGGraphics2D(shapes.createDocument("http://www.w3.org/2000/svg", "svg", null))
    svg.setSVGCanvasSize(new Dimension(width, height))
    val text = new StringWriter
    drawn(svg).stream(text)
    OutputFile.writeText(folder.resolve(s"$name.svg"), text.toString)
    val image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
    drawn(image.createGraphics())
    OutputFile.write(folder.resolve(s"$name.png"))(part => Files.write(part, ChartUtils.encodeAsPNG(image)))
  }
}
