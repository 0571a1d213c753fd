package frustum.command.play

import frustum.command.CommandRunner
import frustum.harness.Simulated
import frustum.play.VirtualDisplay
import org.scalatest.funsuite.AnyFunSuite

import java.awt.GraphicsEnvironment

class PlayCommandTest extends AnyFunSuite {
  test("without a display: one line that tells the remedy") {
    assume(GraphicsEnvironment.isHeadless, "there is a display")
    val run = CommandRunner.run("play", "pong")
    assert(
      run.code == 2 && run.err.length == 1 && run.err.head.startsWith("error: ") && run.err.head.contains(
        "DISPLAY"
      ),
      run
    )
  }

  test("play pong shows frames of the simulated hardware in a window", Simulated) {
    assume(VirtualDisplay.isThere, VirtualDisplay.missing)
    val said = VirtualDisplay.run("frustum.command.Main", 300, "play", "pong", "--frames", "6")
    val rate = """(?s).*6 frames, ([0-9.]+) a second, score 0.*""".r
    said match {
      case rate(perSecond) => assert(perSecond.toDouble > 0, said)
      case _               => fail(said)
    }
  }

  for ((engine, marks) <- Seq("model" -> Nil, "hardware" -> Seq(Simulated)))
    test(s"play voxel shows a world in a window, engine $engine", marks: _*) {
      assume(VirtualDisplay.isThere, VirtualDisplay.missing)
      val said = VirtualDisplay.run(
        "frustum.command.Main",
        300,
        "play",
        "voxel",
        "--frames",
        "3",
        "--size",
        "80x60",
        "--engine",
        engine
      )
      assert(said.contains("3 frames, ") && said.contains("0 edits refused"), said)
    }

  test("play pong in real time by its model, in a window") {
    assume(VirtualDisplay.isThere, VirtualDisplay.missing)
    val said = VirtualDisplay.run("frustum.command.Main", 120, "play", "pong", "--engine", "model", "--frames", "60")
    assert(said.contains("60 frames, ") && said.contains("score 0"), said)
  }

  test("play raster shows a mesh in a window, engine model") {
    assume(VirtualDisplay.isThere, VirtualDisplay.missing)
    val said = VirtualDisplay.run("frustum.command.Main", 120, "play", "raster", "--scene", "cube", "--frames", "5")
    assert(said.contains("5 frames, ") && said.contains("engine model"), said)
  }

  for (
    (words, part) <- Seq(
      "pong --engine pipeline" -> "--engine: 'pipeline' does not play pong; choose one of hardware, model",
      "raster --engine compact" -> "choose one of model, pipeline, hardware, reference",
      "raster --obj missing.obj" -> "missing.obj",
      "raster --obj a.obj --scene cube" -> "--obj",
      "raster --size 0x9" -> "--size",
      "voxel --engine reference" -> "choose one of hardware, model"
    )
  ) test(s"refused in one line: play $words") {
    val run = CommandRunner.run("play" +: words.split(' ').toSeq: _*)
    assert(run.code == 2 && run.err.length == 1 && run.err.head.startsWith("error: "), run)
    assert(run.err.head.contains(part), run)
  }

  test("nothing else can be played") {
    val run = CommandRunner.run("play", "chess")
    assert(run.code == 2 && run.err.head.contains("play voxel"))
  }
}
