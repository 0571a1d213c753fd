package frustum.command

import frustum.command.common.Words
import java.awt.image.BufferedImage
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO

/** What `render` makes of a mesh with the bit-exact model. */
final case class MeshPicture(run: CommandRun, picture: Option[BufferedImage], report: Option[ujson.Value]) {

  /** 0xRRGGBB of a pixel. */
  def apply(x: Int, y: Int): Int = picture.get.getRGB(x, y) & 0xffffff

  /** Pixels that are not black. */
  def covered: Int = {
    val p = picture.get
    (for (y <- 0 until p.getHeight; x <- 0 until p.getWidth) yield p.getRGB(x, y) & 0xffffff).count(_ != 0)
  }

  /** The lines on stderr must be notices. */
  def notices: Seq[String] = {
    assert(run.code == 0 && run.err.forall(_.startsWith("notice: ")), run)
    run.err
  }
}

object MeshPicture {

  /** Looks at the plane z = 0 from the front, its square from -1 to 1 filling the picture. */
  val front: Seq[String] = Words.split("--ortho 2 --eye 0,0,5 --at 0,0,0 --near 1 --far 10")

  def draw(obj: Path, arguments: String*): MeshPicture = {
    val folder = Files.createTempDirectory("render")
    val out = folder.resolve("picture.png")
    val report = folder.resolve("report.json")
    val size = if (arguments.contains("--size")) Nil else Seq("--size", "64x64")
    val run = CommandRunner.run(
      Seq(
        "render",
        "--obj",
        obj.toString,
        "--engine",
        "model",
        "--out",
        out.toString,
        "--report",
        report.toString
      ) ++ size ++
        arguments: _*
    )
    MeshPicture(
      run,
      Option.when(Files.exists(out))(ImageIO.read(out.toFile)),
      Option.when(Files.exists(report))(ujson.read(Files.readString(report)))
    )
  }
}
