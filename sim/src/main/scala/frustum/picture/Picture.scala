package frustum.picture

import frustum.contract.video.ColorFormat
import frustum.files.OutputFile
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO

/** Pictures are 0xRRGGBB, row by row from the top left. */
object Picture {

  /** RGB565 to 0xRRGGBB. */
  def ofRgb565(image: Array[Int]): Array[Int] = ofFormat(image, ColorFormat.Rgb565)

  /** Colours of any format, red in the highest bits, to 0xRRGGBB, each component to the nearest of 0..255. */
  def ofFormat(image: Array[Int], format: ColorFormat): Array[Int] = {
    val Seq(red, green, blue) = format.channels.map { bits =>
      val most = (1 << bits) - 1
      Array.tabulate(most + 1)(v => (v * 255 * 2 + most) / (2 * most))
    }
    image.map { c =>
      red(c >> (format.green + format.blue) & (red.length - 1)) << 16 |
        green(c >> format.blue & (green.length - 1)) << 8 | blue(c & (blue.length - 1))
    }
  }

  /** Amplified absolute difference on white: equal pixels are white, the more two differ the darker, and any
    * difference at all shows.
    */
  def difference(a: Array[Int], b: Array[Int], gain: Int = 8): Array[Int] = {
    require(a.length == b.length, s"pictures of ${a.length} and ${b.length} pixels")
    a.indices.map { i =>
      Seq(16, 8, 0).map { shift =>
        val d = ((a(i) >> shift & 255) - (b(i) >> shift & 255)).abs
        (255 - (d * gain).min(255)) << shift
      }.sum
    }.toArray
  }

  /** Writes a PNG; the file appears whole or not at all. */
  def writePng(file: Path, width: Int, height: Int, rgb: Array[Int]): Unit = {
    require(rgb.length == width * height, s"${rgb.length} pixels for a picture of $width x $height")
    val image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
    image.setRGB(0, 0, width, height, rgb, 0, width)
    OutputFile.write(file)(part => ImageIO.write(image, "png", part.toFile))
  }
}
