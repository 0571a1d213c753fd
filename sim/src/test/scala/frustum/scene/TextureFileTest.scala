package frustum.scene

import org.scalatest.funsuite.AnyFunSuite
import java.awt.image.BufferedImage
import java.nio.file.Files
import javax.imageio.ImageIO

class TextureFileTest extends AnyFunSuite {

  /** What is read of a picture of 8 x 8 whose samples are those of `values` along a row. */
  private def read(kind: Int, values: Int => Int): Seq[Int] = {
    val picture = new BufferedImage(8, 8, kind)
    for (y <- 0 until 8; x <- 0 until 8) picture.getRaster.setSample(x, y, 0, values(x))
    val file = Files.createTempFile("grey", ".png")
    try {
      ImageIO.write(picture, "png", file.toFile)
      TextureFile.read(file).argb.take(8)
    } finally Files.delete(file)
  }

  test("grey values are what the file says, as colours are") {
    val wanted = (0 until 8).map(x => 0xff000000 | 36 * x * 0x010101)
    assert(read(BufferedImage.TYPE_BYTE_GRAY, 36 * _) == wanted)
    assert(read(BufferedImage.TYPE_USHORT_GRAY, 36 * 257 * _) == wanted)
    assert(read(BufferedImage.TYPE_BYTE_BINARY, _ & 1) == (0 until 8).map(x =>
      if (x % 2 == 1) 0xffffffff else 0xff000000
    ))
  }
}
