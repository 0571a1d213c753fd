package frustum.command.render

import frustum.command.CommandRunner
import frustum.command.common.Words
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Path}

/** Bad arguments: exit code 2, one line that names the argument and says what would be right, and no file. */
class RenderArgumentsTest extends AnyFunSuite {
  private val folder: Path = Files.createTempDirectory("render")
  private val out = folder.resolve("picture.png").toString
  private val report = folder.resolve("report.json").toString

  private val table = Seq(
    "--bad" -> Seq("--bad", "--help"),
    "--scene" -> Seq("--scene"),
    "--scene bunny" -> Seq("--scene", "teapot"),
    "stray" -> Seq("stray"),
    "--scene cube --obj x.obj" -> Seq("--obj", "--scene"),
    "--obj /no/such/mesh.obj" -> Seq("/no/such/mesh.obj"),
    "--texture /no/such/picture.png" -> Seq("/no/such/picture.png"),
    "--eye 1,2" -> Seq("--eye", "x,y,z"),
    "--at 1,2,nan" -> Seq("--at", "finite"),
    "--up 1,2,x" -> Seq("--up", "number"),
    "--eye 0,0,0 --at 0,0,0" -> Seq("eye", "at"),
    "--fov 0" -> Seq("--fov", "0"),
    "--fov 180" -> Seq("fov 180.0 must lie"),
    "--near -1" -> Seq("near"),
    "--near 5 --far 4" -> Seq("near", "far"),
    "--ortho 0" -> Seq("--ortho"),
    "--size 240" -> Seq("--size", "240x320"),
    "--size 0x320" -> Seq("--size"),
    "--size 5000x320" -> Seq("--size", "5000"),
    "--light up" -> Seq("--light", "x,y,z"),
    "--cull front" -> Seq("--cull", "back"),
    "--filter bilinear" -> Seq("--filter", "nearest"),
    "--filter cubic" -> Seq("--filter", "cubic"),
    "--wrap border" -> Seq("--wrap", "clamp"),
    "--background red" -> Seq("--background", "RRGGBB"),
    "--engine gpu" -> Seq("--engine", "reference"),
    "--frames 0" -> Seq("--frames"),
    "--frames 2" -> Seq("--out", "%d"),
    "--turn fast" -> Seq("--turn"),
    "--wave x.fst" -> Seq("--wave", "hardware"),
    "--panel st7789" -> Seq("--panel", "reference", "hardware"),
    "--panel vga" -> Seq("--panel", "st7789"),
    "--texture-size 100" -> Seq("--texture-size", "8, 16, 32, 64, 128"),
    "--seed x" -> Seq("--seed")
  )

  for ((line, fragments) <- table) test(s"render $line") {
    val engine = if (line.contains("--engine")) Nil else Seq("--engine", "reference")
    val run = CommandRunner.run("render" +: (Words.split(line) ++ engine ++ Seq(
      "--out",
      out,
      "--report",
      report
    )): _*)
    assert(run.code == 2, run)
    assert(run.err.length == 1 && run.err.head.startsWith("error: "), run)
    fragments.foreach(f => assert(run.err.head.contains(f), run.err.head))
    assert(folder.toFile.list().isEmpty)
  }

  test("an output folder that is a file is refused") {
    val file = Files.createTempFile("render", ".txt")
    val run = CommandRunner.run(
      "render",
      "--engine",
      "reference",
      "--scene",
      "floor",
      "--size",
      "32x32",
      "--out",
      s"$file/a.png",
      "--report",
      report
    )
    assert(run.code == 2 && run.err.length == 1 && run.err.head.contains(file.toString), run)
  }

  test("a report that cannot be written is refused before anything is drawn") {
    val file = Files.createTempFile("render", ".txt")
    val run = CommandRunner.run("render", "--engine", "reference", "--out", out, "--report", s"$file/r.json")
    assert(run.code == 2 && run.err.length == 1 && run.err.head.contains(s"$file/r.json"), run)
    assert(folder.toFile.list().isEmpty && !run.out.contains("teapot"), run)
  }

  test("a command that there is not, and none") {
    assert(CommandRunner.run("rendr").code == 2)
    assert(CommandRunner.run("--line", "render --scene 'cube").code == 2)
    assert(CommandRunner.run("--help").out.contains("demo"))
  }

  test("help prints every option with its default") {
    for (command <- Seq("render", "demo")) {
      val run = CommandRunner.run(command, "--help")
      assert(run.code == 0 && run.err.isEmpty)
      val options = run.out.split("\n  --").drop(1).filterNot(_.startsWith("help"))
      assert(options.length == (if (command == "render") 26 else 3))
      options.filterNot(_.startsWith("obj ")).foreach(o => assert(o.contains("(default"), o))
    }
  }
}
