package frustum.scene

import frustum.contract.InputError
import frustum.driver.scene.TextureImage
import java.awt.color.ColorSpace
import java.awt.image.BufferedImage
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO
import scala.util.control.NonFatal

/** Reads pictures (PNG, and whatever else the Java runtime knows) as textures. */
object TextureFile {

  /** InputError naming the file, and `namedBy` where another file refers to it, when it is missing, damaged,
    * or not of a size the hardware takes.
    *
    * @param fault what is wrong with a width and a height, if anything
    */
  def read(
      file: Path,
      namedBy: Option[SourceLine] = None,
      fault: (Int, Int) => Option[String] = TextureImage.fault
  ): TextureImage = {
    def refuse(what: String): Nothing =
      namedBy.fold[Nothing](throw InputError(s"$file: $what"))(_.error(s"$file: $what"))
    if (!Files.isRegularFile(file)) refuse("there is no such picture; check the name")
    try {
      val stream = ImageIO.createImageInputStream(file.toFile)
      try {
        val readers = ImageIO.getImageReaders(stream)
        if (!readers.hasNext) refuse("is not a picture in a known format; save it as PNG")
        val reader = readers.next
        reader.setInput(stream)
        // before decoding: a wrong size may be a huge one
        fault(reader.getWidth(0), reader.getHeight(0)).foreach(fault => refuse(s"the texture $fault"))
        val picture = reader.read(0)
        val argb = colors(picture)
        TextureImage(picture.getWidth, picture.getHeight, argb.toIndexedSeq, argb.exists(_ >>> 24 != 255))
      } finally stream.close()
    } catch {
      case e: InputError => throw e
      case NonFatal(e)   => refuse(s"the picture is damaged (${e.getMessage}); save it again as PNG")
    }
  }

  /** 0xAARRGGBB row by row. Java takes grey values for linear light and would brighten them; PNG's mean what red, green
    * and blue of that value do.
    */
  private def colors(p: BufferedImage): Array[Int] =
    if (p.getColorModel.getColorSpace.getType != ColorSpace.TYPE_GRAY)
      p.getRGB(0, 0, p.getWidth, p.getHeight, null, 0, p.getWidth)
    else {
      def sample(x: Int, y: Int, band: Int) =
        p.getRaster.getSample(x, y, band) >> (p.getColorModel.getComponentSize(band) - 8)
      val opaque = !p.getColorModel.hasAlpha
      Array.tabulate(p.getHeight * p.getWidth) { i =>
        val (x, y) = (i % p.getWidth, i / p.getWidth)
        (if (opaque) 255 else sample(x, y, 1)) << 24 | sample(x, y, 0) * 0x010101
      }
    }
}
