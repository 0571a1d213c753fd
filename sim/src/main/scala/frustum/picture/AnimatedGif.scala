package frustum.picture

import frustum.files.OutputFile
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.metadata.IIOMetadataNode
import javax.imageio.stream.FileImageOutputStream
import javax.imageio.{IIOImage, ImageIO, ImageTypeSpecifier, ImageWriter}

/** An animated GIF, endlessly repeated, written picture by picture. Each picture gets a palette of the 256
  * colours that suit it best; fewer are kept as they are.
  */
final class AnimatedGif private (writer: ImageWriter, width: Int, height: Int) {
  private val kind = ImageTypeSpecifier.createFromBufferedImageType(BufferedImage.TYPE_INT_RGB)

  /** @param centiseconds that the picture stays, at least 2: many viewers take less for a tenth of a second */
  def add(rgb: Array[Int], centiseconds: Int): Unit = {
    require(rgb.length == width * height, s"${rgb.length} pixels for a picture of $width x $height")
    require(centiseconds >= 2 && centiseconds < 65536, s"a picture of $centiseconds centiseconds")
    val image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
    image.setRGB(0, 0, width, height, rgb, 0, width)
    val data = writer.getDefaultImageMetadata(kind, null)
    val format = data.getNativeMetadataFormatName
    val root = data.getAsTree(format).asInstanceOf[IIOMetadataNode]
    val times = child(root, "GraphicControlExtension")
    times.setAttribute("disposalMethod", "none")
    times.setAttribute("userInputFlag", "FALSE")
    times.setAttribute("transparentColorFlag", "FALSE")
    times.setAttribute("delayTime", centiseconds.toString)
    times.setAttribute("transparentColorIndex", "0")
    val repeat = new IIOMetadataNode("ApplicationExtension")
    repeat.setAttribute("applicationID", "NETSCAPE")
    repeat.setAttribute("authenticationCode", "2.0")
    repeat.setUserObject(Array[Byte](1, 0, 0)) // as often as one looks
    child(root, "ApplicationExtensions").appendChild(repeat)
    data.setFromTree(format, root)
    writer.writeToSequence(new IIOImage(image, null, data), null)
  }

  private def child(root: IIOMetadataNode, name: String): IIOMetadataNode =
    (0 until root.getLength).map(root.item).collectFirst {
      case n: IIOMetadataNode if n.getNodeName == name => n
    }
      .getOrElse {
        val made = new IIOMetadataNode(name)
        root.appendChild(made)
        made
      }
}

object AnimatedGif {

  /** @param body adds the pictures; the file appears whole or not at all */
  def write[A](file: Path, width: Int, height: Int)(body: AnimatedGif => A): A =
    OutputFile.write(file) { part =>
      val writer = ImageIO.getImageWritersByFormatName("gif").next()
      val stream = new FileImageOutputStream(part.toFile)
      try {
        writer.setOutput(stream)
        writer.prepareWriteSequence(null)
        val result = body(new AnimatedGif(writer, width, height))
        writer.endWriteSequence()
        result
      } finally {
        stream.close()
        writer.dispose()
      }
    }
}
