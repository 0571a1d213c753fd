package frustum.command.pong

import frustum.command.CommandRunner
import frustum.harness.Simulated
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import javax.imageio.ImageIO

/** A few frames of the simulated hardware, whole. */
class PongCommandTest extends AnyFunSuite with Simulated {
  test("frames, film and report of a game from a file") {
    val folder = Files.createTempDirectory("pong")
    val input = Files.writeString(Files.createTempFile("buttons", ".txt"), "ur\nu\n")
    val report = folder.resolve("r.json")
    val run =
      CommandRunner.run(
        "pong",
        "--frames",
        "4",
        "--input",
        input.toString,
        "--out",
        folder.toString,
        "--report",
        report.toString
      )
    assert(run.code == 0, run)
    assert(run.out.contains("pong: 4 of 4"), run.out)
    val json = ujson.read(Files.readString(report))
    val zero = Seq(
      "syncErrors",
      "silhouettePixelsWrong",
      "shadowPixelsWrong",
      "objectPixelsWrong",
      "checkerCellsWrong",
      "score"
    )
    zero.foreach(k => assert(json(k).num == 0, k))
    assert(json("hardwareVsModel")("pixelsDifferent").num == 0 && !json("win").bool)
    assert(
      json("frames").num == 4 && json("clocksPerFrame").num == 800 * 525 && json("pixelsPerClock").num == 1
    )
    assert(
      json("latencyClocks").num > 0 && json("psnr").num > 30 && json("sync")("vTotal")("measured").num == 4
    )
    val frames = (0 until 4).map(i => ImageIO.read(folder.resolve(f"frame-$i%04d.png").toFile))
    assert(frames.forall(f => f.getWidth == 640 && f.getHeight == 480))
    assert(Files.size(folder.resolve("pong.gif")) > 1000)
    // The paddle, the only white on the back wall, went up and to the right, then up.
    def white(i: Int) =
      for (y <- 165 until 315; x <- 220 until 420 if (frames(i).getRGB(x, y) & 0xffffff) == 0xffffff)
        yield (x, y)
    val (first, last) = (white(0), white(3))
    assert(last.map(_._1).max > first.map(_._1).max && last.map(_._2).min < first.map(_._2).min)
  }

  test("of a long game, one frame of so many is judged and written") {
    val folder = Files.createTempDirectory("pong")
    val run = CommandRunner.run("pong", "--frames", "5", "--every", "3", "--out", folder.toString)
    assert(run.code == 0, run)
    val json = ujson.read(Files.readString(folder.resolve("pong.json")))
    assert(json("frames").num == 5 && json("framesJudged").num == 2)
    val names = folder.toFile.listFiles.map(_.getName).toSeq.sorted
    assert(names == Seq("frame-0000.png", "frame-0003.png", "pong.gif", "pong.json"))
  }
}
