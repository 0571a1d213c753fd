package frustum.scene

import frustum.InputError
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
        val argb    = picture.getRGB(0, 0, picture.getWidth, picture.getHeight, null, 0, picture.getWidth)
        TextureImage(picture.getWidth, picture.getHeight, argb.toIndexedSeq, argb.exists(_ >>> 24 != 255))
      } finally stream.close()
    } catch {
      case e: InputError => throw e
      case NonFatal(e)   => refuse(s"the picture is damaged (${e.getMessage}); save it again as PNG")
    }
  }
}
