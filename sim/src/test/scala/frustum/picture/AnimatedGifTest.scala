package frustum.picture

import org.scalatest.funsuite.AnyFunSuite

import java.nio.file.Files
import javax.imageio.ImageIO
import javax.imageio.metadata.IIOMetadataNode

class AnimatedGifTest extends AnyFunSuite {
  test("pictures, times and repetition come back") {
    val (width, height) = (24, 16)
    val colors = Seq(0x000000, 0xff0000, 0x00ff40, 0x2040ff, 0xffff00, 0x888888)
    val pictures = Seq.tabulate(3)(f => Array.tabulate(width * height)(i => colors((i + f) % colors.size)))
    val file = Files.createTempDirectory("gif").resolve("a.gif")
    AnimatedGif.write(file, width, height)(gif =>
      pictures.zip(Seq(3, 4, 100)).foreach { case (p, t) => gif.add(p, t) }
    )
    val reader = ImageIO.getImageReadersByFormatName("gif").next()
    reader.setInput(ImageIO.createImageInputStream(file.toFile))
    assert(reader.getNumImages(true) == 3)
    for (i <- 0 to 2) {
      val image = reader.read(i)
      assert(image.getRGB(0, 0, width, height, null, 0, width).map(_ & 0xffffff).toSeq == pictures(i).toSeq)
      val data = reader.getImageMetadata(i)
      val root = data.getAsTree(data.getNativeMetadataFormatName).asInstanceOf[IIOMetadataNode]
      def node(name: String) = root.getElementsByTagName(name).item(0).asInstanceOf[IIOMetadataNode]
      assert(node("GraphicControlExtension").getAttribute("delayTime") == Seq("3", "4", "100")(i))
      assert(node("ApplicationExtension").getUserObject.asInstanceOf[Array[Byte]].toSeq == Seq[Byte](1, 0, 0))
    }
  }

  test("a picture of another size, or too short a time, is refused and leaves no file") {
    val file = Files.createTempDirectory("gif").resolve("a.gif")
    assertThrows[IllegalArgumentException](AnimatedGif.write(file, 4, 4)(_.add(new Array[Int](12), 3)))
    assertThrows[IllegalArgumentException](AnimatedGif.write(file, 4, 4)(_.add(new Array[Int](16), 1)))
    assert(!Files.exists(file))
  }
}
