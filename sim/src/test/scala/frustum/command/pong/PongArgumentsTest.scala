package frustum.command.pong

import frustum.boards.icebreaker.IcebreakerTops
import frustum.command.CommandRunner
import frustum.command.common.Words
import frustum.contract.video.VideoMode
import org.scalatest.funsuite.AnyFunSuite
import java.awt.image.BufferedImage
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO

/** Bad arguments of `pong` and `play`: exit code 2, one line that says what would be right, and no file. */
class PongArgumentsTest extends AnyFunSuite {
  private val folder: Path = Files.createTempDirectory("pong")
  private val inputs = Files.createTempDirectory("pong-inputs")
  private def file(name: String, text: String) = Files.writeString(inputs.resolve(name), text).toString

  private val letters = file("letters.txt", "u\n-\nlx\n")
  private val empty = file("none.json", """{"spheres": []}""")
  private val still =
    file("still.json", """{"spheres": [{"centre": [0, 0, 320], "radius": 20, "color": "ff0000"}]}""")
  private val moving = file(
    "moving.json",
    """{"camera": {"lengths": [300, 900],
      "low":  {"eye": [0, 0, -320], "corner": [-700, -700, -700], "right": [-2, -2, -2], "down": [-2, -2, -2]},
      "high": {"eye": [0, 0, -300], "corner": [700, 700, 700], "right": [2, 2, 2], "down": [2, 2, 2]}}}"""
  )
  private val remote = file("remote.json", """{"camera": {"eye": [0, 0, -100000], "focal": 320}}""")
  private val second = file(
    "two.json",
    """{"spheres": [{"low": [-300, -220, 20], "high": [300, 220, 620], "radius": 20, "color": "ff0000"},
      {"low": [0, 0, -99], "high": [1, 0, -99], "radius": 20, "color": "00ff00"}]}"""
  )
  private val tiles = {
    ImageIO.write(new BufferedImage(128, 64, BufferedImage.TYPE_INT_RGB), "png", inputs.resolve("tiles.png").toFile)
    file(
      "tiles.json",
      """{"room": {"low": [-320, -240, 0], "high": [320, 240, 640], "cellBits": 6,
        "walls": {"back": {"image": "tiles.png", "texelBits": 2}, "floor": {"image": "tiles.png", "texelBits": 2}}}}"""
    )
  }
  private val broken = file("broken.json", "{\n  \"light\": [1, 2,\n")

  private val table = Seq(
    "pong --bad" -> Seq("--bad", "--help"),
    "pong stray" -> Seq("stray"),
    "pong --frames 0" -> Seq("--frames", "10000"),
    "pong --mode 1024x768" -> Seq("--mode", "640x480", "800x600"),
    "pong --seed x" -> Seq("--seed"),
    s"pong --autoplay --input '$letters'" -> Seq("--autoplay", "--input"),
    "pong --input /no/such/file.txt" -> Seq("/no/such/file.txt"),
    s"pong --input '$letters'" -> Seq("letters.txt:3:", "'x'", "u d l r"),
    "pong --scene /no/such/scene.json" -> Seq("/no/such/scene.json"),
    s"pong --scene '$broken'" -> Seq("broken.json:", "JSON"),
    s"pong --scene '$empty'" -> Seq("none.json", "0 spheres"),
    s"pong --scene '$still'" -> Seq("still.json", "puck", "(-300, -220, 20)"),
    s"pong --scene '$moving'" -> Seq("moving.json", "camera is constant", "(0, 0, -300)"),
    s"pong --scene '$second'" -> Seq("two.json", "sphere 1 moves", "centre"),
    s"pong --scene '$remote'" -> Seq("remote.json", "bits", "at most 64"),
    s"pong --scene '$tiles'" -> Seq("tiles.json", "192 kbit", "iCE40UP5K", "120"),
    "pong --top arty-voxel" -> Seq("--top", "arty-pong"),
    "play" -> Seq("play pong"),
    "play chess" -> Seq("chess", "play pong"),
    "play pong --frames x" -> Seq("--frames")
  )

  for ((line, fragments) <- table) test(line.replace(inputs.toString, "")) {
    val out = if (line.startsWith("pong")) Seq("--out", folder.resolve("frames").toString) else Nil
    val run = CommandRunner.run(Words.split(line) ++ out: _*)
    assert(run.code == 2, run)
    assert(run.err.length == 1 && run.err.head.startsWith("error: "), run)
    fragments.foreach(f => assert(run.err.head.contains(f), run.err.head))
    assert(folder.toFile.list().isEmpty)
  }

  test("what pong simulates is what the iCEBreaker's top is built with") {
    assert(PongScenes.config(VideoMode.Vga640x480, None) == IcebreakerTops.pongConfig)
  }

  test("--out that is a file is refused") {
    val run = CommandRunner.run("pong", "--out", letters)
    assert(run.code == 2 && run.err.length == 1 && run.err.head.contains("letters.txt"), run)
  }
}
