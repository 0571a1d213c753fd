package frustum.scene

import java.awt.image.BufferedImage
import java.nio.charset.{Charset, StandardCharsets}
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO

/** Folders with small meshes and pictures. */
object MeshFiles {

  /** Corners of a square from -1 to 1 in the plane z = 0, with texture coordinates from 0 to 1. */
  val square: String =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"

  /** The square as a face of material m of m.mtl. */
  val texturedSquare: String = s"mtllib m.mtl\n${square}usemtl m\nf 1/1 2/2 3/3 4/4\n"

  /** Runs `body` in a folder with these text files, and removes it. */
  def withFiles[T](files: (String, String)*)(body: Path => T): T = {
    val folder = Files.createTempDirectory("frustum")
    try {
      for ((name, text) <- files) write(folder.resolve(name), text)
      body(folder)
    } finally {
      val all = Files.walk(folder)
      try all.sorted(java.util.Comparator.reverseOrder[Path]).forEach(f => Files.delete(f))
      finally all.close()
    }
  }

  def write(file: Path, text: String, charset: Charset = StandardCharsets.UTF_8): Unit = {
    Files.createDirectories(file.getParent)
    Files.write(file, text.getBytes(charset))
  }

  /** @param format as Java names it; `color` is 0xAARRGGBB of the texel at x, y, from the top left */
  def picture(file: Path, width: Int, height: Int, format: String = "png")(color: (Int, Int) => Int): Unit = {
    val kind = if (format == "png") BufferedImage.TYPE_INT_ARGB else BufferedImage.TYPE_3BYTE_BGR
    val picture = new BufferedImage(width, height, kind)
    for (y <- 0 until height; x <- 0 until width) picture.setRGB(x, y, color(x, y))
    assert(ImageIO.write(picture, format, file.toFile), s"no writer for $format")
  }

  /** Four quarters: top left yellow, top right blue, bottom left blue, bottom right yellow. */
  def quarters(file: Path, side: Int = 8, format: String = "png"): Unit =
    picture(file, side, side, format)((x, y) => if ((x * 2 / side + y * 2 / side) % 2 == 0) Yellow else Blue)

  val Yellow = 0xffffff00
  val Blue = 0xff0000ff
}
