package frustum.scene

import frustum.contract.InputError
import frustum.driver.scene.TextureImage
import frustum.files.InputFile
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream
import java.awt.color.ColorSpace
import java.awt.image.BufferedImage
import java.nio.file.{Files, Path}
import javax.imageio.{ImageIO, ImageReader}
import scala.util.control.NonFatal

/** Reads pictures (PNG, JPEG, TGA, and whatever else the Java runtime knows) as textures. */
object TextureFile {

  /** Texels of the largest picture that is decoded; more would not leave room for anything else. */
  private val Largest = 1L << 26

  /** Opacities that count as none and as whole, of 255: what scanning and compression leave of a hole. */
  private val HoleBelow = 9
  private val SolidAbove = 246

  /** InputError naming the file, and `namedBy` where another file refers to it, when it is missing, damaged,
    * or not of a size the hardware takes.
    *
    * @param fault what is wrong with a width and a height, if anything
    */
  def read(
      file: Path,
      namedBy: Option[SourceLine] = None,
      fault: (Int, Int) => Option[String] = TextureImage.fault
  ): TextureImage = decode(file, namedBy) { (reader, refuse) =>
    fault(reader.getWidth(0), reader.getHeight(0)).foreach(fault => refuse(s"the texture $fault"))
    image(reader, identity, reader.getWidth(0), reader.getHeight(0))
  }

  /** A picture at another size, see [[AreaAverage]]; untouched where it has that size. What has holes but nothing half
    * transparent stays so.
    *
    * @param convert what a texel 0xAARRGGBB stands for, before the average
    */
  def resampled(
      file: Path,
      namedBy: Option[SourceLine],
      size: (Int, Int),
      convert: Int => Int = identity
  ): TextureImage =
    decode(file, namedBy)((reader, _) => image(reader, convert, size._1, size._2))

  /** Width and height; the texels are not looked at, the checksums are. */
  def size(file: Path, namedBy: Option[SourceLine]): (Int, Int) =
    decode(file, namedBy)((reader, _) => (reader.getWidth(0), reader.getHeight(0)))

  /** Whether the file is there and a picture in a format that can be read. */
  def known(file: Path): Boolean = Files.isRegularFile(file) &&
    ImageIO.getImageReaders(stream(bytes(file))).hasNext

  private def bytes(file: Path) = InputFile.bytes(file, "save it as PNG")

  /** The TGA reader looks for a footer without asking whether there is room for one; what follows a picture is
    * ignored.
    */
  private def stream(content: Array[Byte]) =
    new ByteArrayImageInputStream(java.util.Arrays.copyOf(content, content.length.max(64)))

  private def decode[A](file: Path, namedBy: Option[SourceLine])(use: (ImageReader, String => Nothing) => A): A = {
    def refuse(what: String): Nothing =
      namedBy.fold[Nothing](throw InputError(s"$file: $what"))(_.error(s"$file: $what"))
    def damaged(how: String): Nothing = refuse(s"the picture is damaged ($how); save it again as PNG")
    if (!Files.isRegularFile(file)) refuse("there is no such picture; check the name")
    val content = bytes(file)
    PngChecksums.fault(content).foreach(damaged)
    try {
      val input = stream(content)
      try {
        val readers = ImageIO.getImageReaders(input)
        if (!readers.hasNext) refuse("is not a picture in a known format; save it as PNG")
        val reader = readers.next
        reader.setInput(input)
        // Java's JPEG reader paints what is missing grey and only warns
        reader.addIIOReadWarningListener((_: ImageReader, warning: String) =>
          if (warning.matches("(?i).*(premature|corrupt|truncated|missing EOI).*")) damaged(warning)
        )
        // before decoding
        if (reader.getWidth(0).toLong * reader.getHeight(0) > Largest)
          refuse(s"a picture of ${reader.getWidth(0)} x ${reader.getHeight(0)}; at most 8192 x 8192: scale it down")
        try use(reader, refuse)
        finally reader.dispose()
      } finally input.close()
    } catch {
      case e: InputError => throw e
      case NonFatal(e)   => damaged(Option(e.getMessage).getOrElse(e.getClass.getSimpleName))
    }
  }

  private def image(reader: ImageReader, convert: Int => Int, width: Int, height: Int): TextureImage = {
    val picture = reader.read(0)
    var partly = false
    def row(y: Int) = {
      val argb = colors(picture, y).map(convert)
      partly ||= argb.exists(c => c >>> 24 >= HoleBelow && c >>> 24 <= SolidAbove)
      argb
    }
    val argb =
      if (picture.getWidth == width && picture.getHeight == height) Array.tabulate(height)(row).flatten
      else {
        val averaged = AreaAverage(picture.getWidth, picture.getHeight, row, width, height)
        if (partly) averaged else averaged.map(cutOut)
      }
    TextureImage(width, height, argb.toIndexedSeq, argb.exists(_ >>> 24 != 255))
  }

  /** A texel that is a hole or solid. */
  private def cutOut(argb: Int): Int = if (argb >>> 24 < 128) argb & 0xffffff else argb | 0xff000000

  /** 0xAARRGGBB of a row. Java takes grey values for linear light and would brighten them; a file's mean what red,
    * green and blue of that value do.
    */
  private def colors(p: BufferedImage, y: Int): Array[Int] =
    if (p.getColorModel.getColorSpace.getType != ColorSpace.TYPE_GRAY)
      p.getRGB(0, y, p.getWidth, 1, null, 0, p.getWidth)
    else {
      def sample(x: Int, band: Int) = p.getRaster.getSample(x, y, band) >> (p.getColorModel.getComponentSize(band) - 8)
      val opaque = !p.getColorModel.hasAlpha
      Array.tabulate(p.getWidth)(x => (if (opaque) 255 else sample(x, 1)) << 24 | sample(x, 0) * 0x010101)
    }
}
