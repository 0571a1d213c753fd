package frustum.picture

import frustum.contract.video.ColorFormat
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import javax.imageio.ImageIO

class PictureTest extends AnyFunSuite {
  test("RGB565 widens to the nearest of 0..255") {
    assert(Picture.ofRgb565(Array(0, 0xffff, 0xf800, 0x07e0, 0x001f, 0x8410)).toSeq ==
      Seq(0, 0xffffff, 0xff0000, 0x00ff00, 0x0000ff, 0x848284))
  }

  test("a difference is white where equal, and shows a single level") {
    assert(Picture.difference(Array(0x102030, 0x102030, 0), Array(0x102030, 0x112030, 0xffffff)).toSeq ==
      Seq(0xffffff, 0xf7ffff, 0x000000))
  }

  test("a PNG reads back as it was and leaves nothing else behind") {
    val folder = Files.createTempDirectory("picture")
    val image = Array.tabulate(12)(i => i * 0x010305)
    Picture.writePng(folder.resolve("deep/a.png"), 4, 3, image)
    val read = ImageIO.read(folder.resolve("deep/a.png").toFile)
    assert((0 until 12).forall(i => (read.getRGB(i % 4, i / 4) & 0xffffff) == image(i)))
    assert(folder.resolve("deep").toFile.list().toSeq == Seq("a.png"))
  }

  test("colours of any format widen to the nearest of 0..255") {
    assert(Picture.ofFormat(Array(0xfff, 0x000, 0x1a5), ColorFormat.Rgb444).toSeq == Seq(0xffffff, 0, 0x11aa55))
    assert(Picture.ofFormat(Array(0xff, 0x25, 0x82), ColorFormat.Rgb332).toSeq == Seq(0xffffff, 0x242455, 0x9200aa))
    assert(Picture.ofFormat(Array(0x123456), ColorFormat.Rgb888).toSeq == Seq(0x123456))
  }
}
