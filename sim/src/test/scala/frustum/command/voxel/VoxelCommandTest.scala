package frustum.command.voxel

import frustum.command.CommandRunner
import frustum.command.common.Words
import frustum.harness.Simulated
import frustum.scene.VoxWriter
import org.scalatest.funsuite.AnyFunSuite
import java.awt.image.BufferedImage
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO

/** `voxel`: what it writes, and that bad arguments and files give exit code 2, one line that says what would be right,
  * and no file.
  */
class VoxelCommandTest extends AnyFunSuite {
  private val folder: Path = Files.createTempDirectory("voxel")
  private val inputs = Files.createTempDirectory("voxel-inputs")
  private def file(name: String, bytes: Array[Byte]): String =
    Files.write(inputs.resolve(name), bytes).toString
  private def file(name: String, text: String): String = file(name, text.getBytes)
  private def png(name: String, width: Int, height: Int)(rgb: (Int, Int) => Int): Unit = {
    val image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
    for (x <- 0 until width; y <- 0 until height) image.setRGB(x, y, rgb(x, y))
    ImageIO.write(image, "png", inputs.resolve(name).toFile)
  }
  png("large.png", 32, 16)((_, _) => 0)
  png("many.png", 16, 16)((x, y) => x * 17 << 16 | y * 17)

  private val short = file("short.raw", new Array[Byte](100))
  private val high = file("high.raw", Array.fill[Byte](512)(1).updated(77, 30.toByte))
  private val notVox = file("not.vox", "RIFF....")
  private val cut = file(
    "cut.vox",
    "VOX ".getBytes ++ Array[Byte](-106, 0, 0, 0) ++ "MAIN".getBytes ++ Array[Byte](0, 0, 0, 0, 9, 0, 0, 0)
  )
  private val poses = file("poses.txt", "1 2 3 4 5\n1 2 three 4 5\n")
  private val farPoses = file("far.txt", "1 2 3 4 5\n\n1 2 -99 4 5\n")
  private val noTable = file("no.json", "{\"name\": \"x\"}")
  private val noName = file("name.json", "[{\"texture\": \"stone\"}]")
  private val noKey = file("key.json", "[{\"name\": \"a\", \"txture\": \"stone\"}]")
  private val noPaint = file("paint.json", "[{\"name\": \"a\", \"texture\": \"velvet\"}]")
  private val wide = file("wide.json", "[{\"name\": \"a\", \"texture\": \"large.png\"}]")
  private val colorful = file("many.json", "[{\"name\": \"a\", \"texture\": \"many.png\"}]")
  private val seeThrough = file("glass.json", "[{\"name\": \"a\", \"texture\": \"glass\"}]")
  private val noBlocks = file("empty.json", "[]")
  private val allClear = file("clear.json", "[{\"name\": \"a\", \"texture\": \"glass\", \"opaque\": false}]")
  private val twice = file("twice.json", "[{\"name\": \"a\",\n \"texture\": \"sand\", \"name\": \"b\"}]")
  private val cubes = vox(
    "cubes.vox",
    VoxWriter.full((3, 3, 3), 1),
    VoxWriter.full((2, 2, 2), 2),
    VoxWriter.scene(Seq("_t" -> "-4 0 1"), Seq("_t" -> "4 0 1"))
  )
  private val hollow = vox("hollow.vox", VoxWriter.model((3, 3, 3)))
  private val sizeOnly = vox("size.vox", VoxWriter.chunk("SIZE", VoxWriter.ints(3, 3, 3)))
  private val wideVox = vox("wide.vox", VoxWriter.full((40, 2, 2), 1))
  private def vox(name: String, chunks: Array[Byte]*): String =
    file(name, Files.readAllBytes(VoxWriter.file(chunks: _*)))

  private val table = Seq(
    "--bad" -> Seq("--bad", "--help"),
    "--engine netlist" -> Seq("--engine", "model"),
    "--size 17x19" -> Seq("--size 17x19", "--engine pipeline"),
    "--world /no/such.raw" -> Seq("/no/such.raw"),
    s"--world '$short'" -> Seq("short.raw", "100 bytes", "131072", "--world-size"),
    s"--world '$high' --world-size 8x8x8" -> Seq("high.raw", "byte 77", "30", "24"),
    s"--world '$notVox'" -> Seq("not.vox", "byte 0", "MagicaVoxel"),
    s"--world '$cut'" -> Seq("cut.vox", "byte 20"),
    "--world-size 60x64x32" -> Seq("--world-size", "power of two"),
    "--world-size 64x64" -> Seq("--world-size"),
    "--eye 500,0,0" -> Seq("--eye", "x 500", "32 blocks"),
    "--eye 1e300,0,0" -> Seq("--eye", "x 1.0E300", "32 blocks"),
    "--look 0,0,0" -> Seq("--look"),
    "--look 1,0,0 --yaw 50" -> Seq("--look", "--yaw", "one of them"),
    s"--path '$poses' --pitch 5" -> Seq("--path", "--pitch", "one of them"),
    "--pitch 91" -> Seq("--pitch", "-90 to 90"),
    "--focal 60" -> Seq("--focal", "too wide"),
    "--size 8x8" -> Seq("--size", "width 8"),
    "--distance 100" -> Seq("--distance", "60"),
    s"--path '$poses'" -> Seq("poses.txt:2", "x y z yaw pitch"),
    s"--path '$farPoses'" -> Seq("far.txt:3", "eye: z -99"),
    s"--blocks '$noTable'" -> Seq("no.json", "list"),
    s"--world '$high' --blocks '$noName'" -> Seq("name.json", "block 1", "no name"),
    s"--world '$high' --blocks '$noKey'" -> Seq("key.json", "block 1", "txture"),
    s"--world '$high' --blocks '$noPaint'" -> Seq("paint.json", "velvet"),
    s"--world '$high' --blocks '$wide'" -> Seq("wide.json", "large.png", "32 x 16"),
    s"--world '$high' --blocks '$colorful'" -> Seq("many.json", "many.png", "colours"),
    s"--world '$high' --blocks '$seeThrough'" -> Seq("glass.json:1: ", "opaque"),
    s"--world '$high' --blocks '$noBlocks'" -> Seq("empty.json:1: ", "no blocks"),
    s"--world '$cubes' --blocks '$allClear'" -> Seq("clear.json", "opaque"),
    s"--world '$high' --blocks '$twice'" -> Seq("twice.json:2: ", "'name' comes twice"),
    s"--world '$hollow'" -> Seq("hollow.vox", "no voxels"),
    s"--world '$sizeOnly'" -> Seq("size.vox", "XYZI"),
    s"--world '$wideVox' --world-size 8x8x8" -> Seq(
      "wide.vox",
      "40x2x2",
      "8x8x8",
      "--world-size 64x4x4",
      "--crop x,y,z"
    ),
    s"--world '$wideVox' --crop 1,2" -> Seq("--crop", "'1,2'"),
    s"--world '$wideVox' --crop 0,2,0" -> Seq("--crop 0,2,0", "40x2x2"),
    s"--world '$high' --crop 0,0,0" -> Seq("--crop", ".vox"),
    "--opaque" -> Seq("--opaque", ".vox"),
    "--size 48x16" -> Seq("--size 48x16", "15.0 pixels", "--engine pipeline")
  )

  for ((line, fragments) <- table) test(s"refused: ${line.replace(inputs.toString, "")}") {
    val run = CommandRunner.run("voxel" +: (Words.split(line) ++ Seq(
      "--out",
      folder.resolve("refused.png").toString
    )): _*)
    assert(run.code == 2, run)
    assert(run.err.length == 1 && run.err.head.startsWith("error: "), run)
    fragments.foreach(f => assert(run.err.head.contains(f), run.err.head))
    assert(folder.toFile.list().isEmpty)
  }

  test("model: pictures of a path and a report") {
    val out = Files.createTempDirectory("voxel-model")
    val path = file("path.txt", "32 32 20 0 -20\n\n30 30 20 90 10\n")
    val run = CommandRunner.run(
      "voxel",
      "--engine",
      "model",
      "--size",
      "32x24",
      "--path",
      path,
      "--out",
      out.resolve("p.png").toString
    )
    assert(run.code == 0, run)
    assert(out.toFile.list().toSet == Set("p-0.png", "p-1.png", "voxel.json"))
    val report = ujson.read(Files.readString(out.resolve("voxel.json")))
    assert(report("frames").num == 2 && report("rays").num == 2 * 32 * 24 && report("blocksWrong").num == 0)
    assert(report("steps").num < report("plainSteps").num && !report.obj.contains("clocksPerFrame"))
  }

  test("a scene of MagicaVoxel: notices on stderr, one a kind, and the blocks of the board where a board is told") {
    val out = Files.createTempDirectory("voxel-vox")
    def draw(more: String*) = CommandRunner.run(
      Seq(
        "voxel",
        "--engine",
        "model",
        "--size",
        "32x24",
        "--world-size",
        "16x16x8",
        "--world",
        cubes,
        "--out",
        out.resolve("p.png").toString
      ) ++ more: _*
    )
    val plain = draw()
    assert(plain.code == 0 && plain.err.isEmpty, plain)
    val cut = draw("--crop", "2,0,0")
    assert(
      cut.code == 0 && cut.err.length == 1 && cut.err.head.startsWith("notice: ") && cut.err.head.endsWith("(18)"),
      cut
    )
    val board = draw("--serial", out.resolve("w.bin").toString)
    assert(board.code == 0 && board.err.length == 1 && board.err.head.contains("nearest of 24 blocks"), board)
  }

  test("--serial: a command for each word, then the camera, each with a sum of 0") {
    val out = Files.createTempDirectory("voxel-serial")
    val file = out.resolve("world.bin")
    val run = CommandRunner.run(
      "voxel",
      "--engine",
      "model",
      "--size",
      "32x24",
      "--world-size",
      "8x8x8",
      "--serial",
      file.toString,
      "--out",
      out.resolve("p.png").toString
    )
    assert(run.code == 0, run)
    val bytes = Files.readAllBytes(file)
    val writes = bytes.dropRight(47).grouped(8).toSeq
    assert(writes.length == 512 && writes.forall(w => w.head == 'W' && (w.sum & 255) == 0))
    assert(bytes.takeRight(47).head == 'C' && (bytes.takeRight(47).sum & 255) == 0)
  }

  // The iCE40's pipeline draws a ray after the other.
  for ((engine, size, clocks) <- Seq(("hardware", "64x48", 1.2), ("pipeline", "33x25", 1.2), ("compact", "40x32", 3.0)))
    test(s"$engine: the model's picture, at most $clocks clocks a step", Simulated) {
      val out = Files.createTempDirectory("voxel-hardware")
      val run = CommandRunner.run(
        "voxel",
        "--engine",
        engine,
        "--size",
        size,
        "--world-size",
        "16x16x16",
        "--highlight",
        "--out",
        out.resolve("h.png").toString
      )
      assert(run.code == 0, run)
      val report = ujson.read(Files.readString(out.resolve("voxel.json")))
      assert(report("hardwareVsModel")("pixelsDifferent").num == 0)
      assert(report("clocksPerStep").num >= 1 && report("clocksPerStep").num < clocks)
      val picture = ImageIO.read(out.resolve("h.png").toFile)
      assert(s"${picture.getWidth}x${picture.getHeight}" == size)
    }
}
