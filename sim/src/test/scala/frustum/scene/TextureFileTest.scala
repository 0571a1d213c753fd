package frustum.scene

import frustum.contract.InputError
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

  private def folder[T](body: java.nio.file.Path => T): T = MeshFiles.withFiles()(body)

  /** Where each chunk of a PNG file begins, with its type. */
  private def chunks(file: Array[Byte]): Seq[(String, Int)] = {
    val b = java.nio.ByteBuffer.wrap(file)
    Iterator.iterate(8)(at => at + 12 + b.getInt(at)).takeWhile(_ + 12 <= file.length)
      .map(at => new String(file, at + 4, 4) -> at).toSeq
  }

  test("a wrong checksum of what a PNG is made of is refused, naming the file") {
    folder { d =>
      val file = d.resolve("a.png")
      MeshFiles.picture(file, 8, 8)((x, y) => 0xff000000 | x * 30 << 16 | y * 30)
      val whole = Files.readAllBytes(file)
      TextureFile.read(file)
      for (
        (kind, at) <- chunks(whole) if Set("IHDR", "IDAT", "IEND")(kind);
        length = java.nio.ByteBuffer.wrap(whole).getInt(at)
      ) {
        val damaged = whole.clone
        damaged(at + 8 + length) = (damaged(at + 8 + length) ^ 1).toByte
        Files.write(file, damaged)
        for (read <- Seq(() => TextureFile.read(file), () => TextureFile.size(file, None)))
          assert(intercept[InputError](
            read()
          ).message == s"$file: the picture is damaged (the checksum of its chunk $kind is wrong); save it again as " +
            "PNG")
      }
      val wider = whole.clone
      wider(19) = 16
      Files.write(file, wider)
      assert(intercept[InputError](TextureFile.read(file)).message.contains("checksum of its chunk IHDR"))
      for (length <- Seq(whole.length - 20, 40, 20, 9)) {
        Files.write(file, whole.take(length))
        assert(intercept[InputError](TextureFile.read(file)).message.contains("damaged"), length)
      }
    }
  }

  test("PNG: a wrong checksum of the palette and of its transparency is refused, of a comment not") {
    folder { d =>
      val file = d.resolve("a.png")
      val palette = new java.awt.image.IndexColorModel(
        8,
        4,
        Array[Byte](0, 1, 2, 3),
        Array[Byte](9, 8, 7, 6),
        Array[Byte](0, 0, 0, 9),
        2
      )
      ImageIO.write(new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_INDEXED, palette), "png", file.toFile)
      val whole = Files.readAllBytes(file)
      val kinds = chunks(whole).toMap
      for (kind <- Seq("PLTE", "tRNS")) {
        val damaged = whole.clone
        damaged(kinds(kind) + 8) = (damaged(kinds(kind) + 8) ^ 1).toByte
        Files.write(file, damaged)
        assert(intercept[InputError](TextureFile.read(file)).message.contains(s"checksum of its chunk $kind"), kind)
      }
      val text = java.nio.ByteBuffer.allocate(
        12 + 5
      ).putInt(5).put("tEXta".getBytes).put(0.toByte).put("abc".getBytes).putInt(0).array
      Files.write(file, whole.take(33) ++ text ++ whole.drop(33))
      TextureFile.read(file)
    }
  }

  test("JPEG, colours and grey; one that is cut off is refused") {
    folder { d =>
      val file = d.resolve("a.jpg")
      MeshFiles.picture(file, 64, 64, "jpg")((_, _) => 0xff3366cc)
      val whole = TextureFile.read(file)
      assert(whole.argb.forall(c =>
        Seq(16, 8, 0).forall(s => ((c >> s & 255) - (0xff3366cc >> s & 255)).abs <= 4)
      ) && !whole.hasAlpha)
      val bytes = Files.readAllBytes(file)
      Files.write(file, bytes.take(bytes.length - 30))
      assert(intercept[InputError](TextureFile.read(file)).message.contains("a.jpg: the picture is damaged"))
      val grey = new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY)
      for (y <- 0 until 8; x <- 0 until 8) grey.getRaster.setSample(x, y, 0, 100)
      ImageIO.write(grey, "jpg", file.toFile)
      assert(TextureFile.read(file).argb.forall(_ == 0xff646464))
    }
  }

  /** An uncompressed TGA file: 18 bytes of header, then the rows, blue first, from the bottom where `flags` has no
    * 0x20.
    */
  private def tga(width: Int, height: Int, kind: Int, bits: Int, flags: Int, texels: Seq[Int]): Array[Byte] =
    (Seq(
      0,
      0,
      kind,
      0,
      0,
      0,
      0,
      0,
      0,
      0,
      0,
      0,
      width & 255,
      width >> 8,
      height & 255,
      height >> 8,
      bits,
      flags
    ) ++ texels).map(_.toByte).toArray

  test("TGA: from the bottom and from the top, with alpha, run lengths, grey") {
    folder { d =>
      val file = d.resolve("a.tga")
      def read(b: Array[Byte]) = { Files.write(file, b); TextureFile.read(file) }
      val (up, down) = (Seq.fill(32)(Seq(0xcc, 0x66, 0x33)).flatten, Seq.fill(32)(Seq(1, 2, 3)).flatten)
      val bottomFirst = read(tga(8, 8, 2, 24, 0, up ++ down)).argb
      assert(bottomFirst.take(32).forall(_ == 0xff030201) && bottomFirst.drop(32).forall(_ == 0xff3366cc))
      assert(read(tga(8, 8, 2, 24, 0x20, up ++ down)).argb.take(32).forall(_ == 0xff3366cc))
      assert(read(tga(8, 8, 2, 32, 0x28, Seq.fill(64)(Seq(1, 2, 3, 0x80)).flatten)).argb.forall(_ == 0x80030201))
      assert(read(tga(8, 8, 10, 24, 0x20, Seq.fill(4)(Seq(0x8f, 1, 2, 3)).flatten)).argb.forall(_ == 0xff030201))
      assert(read(tga(8, 8, 3, 8, 0x20, Seq.fill(64)(77))).argb.forall(_ == 0xff4d4d4d))
    }
  }

  test("resampled: holes stay holes, haze stays haze, an exact size is untouched") {
    folder { d =>
      val file = d.resolve("a.png")
      MeshFiles.picture(file, 100, 60)((x, _) => if (x / 25 % 2 == 0) 0x00ff0000 else 0xff00ff00)
      val holes = TextureFile.resampled(file, None, (16, 16))
      assert(holes.argb.map(_ >>> 24).toSet.subsetOf(Set(0, 255)) && holes.hasAlpha)
      assert(holes.argb.filter(_ >>> 24 != 0).forall(_ == 0xff00ff00))
      MeshFiles.picture(file, 100, 60)((_, _) => 0x4000ff00)
      assert(TextureFile.resampled(file, None, (16, 16)).argb.toSet == Set(0x4000ff00))
      MeshFiles.picture(file, 16, 8)((x, y) => x << 28 | y << 17 | 5)
      assert(TextureFile.resampled(file, None, (16, 8)) == TextureFile.read(file))
    }
  }

  test("a picture too large to decode is refused before it is") {
    folder { d =>
      val file = d.resolve("a.png")
      MeshFiles.picture(file, 8, 8)((_, _) => -1)
      val bytes = java.nio.ByteBuffer.wrap(Files.readAllBytes(file))
      bytes.putInt(16, 60000).putInt(20, 60000)
      val crc = new java.util.zip.CRC32
      crc.update(bytes.array, 12, 17)
      bytes.putInt(29, crc.getValue.toInt)
      Files.write(file, bytes.array)
      assert(intercept[InputError](TextureFile.size(
        file,
        None
      )).message.contains("a picture of 60000 x 60000; at most 8192 x 8192"))
    }
  }
}
