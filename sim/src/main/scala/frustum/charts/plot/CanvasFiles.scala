package frustum.charts.plot

import frustum.files.OutputFile
import java.io.ByteArrayOutputStream
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO

/** A drawing as two files: pixels for pages, and shapes and words that stay sharp at any size. */
object CanvasFiles {

  /** Writes `<name>.png` and `<name>.svg`. */
  def write(folder: Path, name: String, width: Int, height: Int)(draw: Canvas => Unit): Unit = {
    val svg = new SvgCanvas(width, height)
    draw(svg)
    OutputFile.writeText(folder.resolve(s"$name.svg"), svg.document)
    val pixels = new PixelCanvas(width, height)
    draw(pixels)
    val bytes = new ByteArrayOutputStream
    ImageIO.write(pixels.image, "png", bytes)
    OutputFile.write(folder.resolve(s"$name.png"))(part => Files.write(part, bytes.toByteArray))
  }
}
