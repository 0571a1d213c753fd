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
    assume(VirtualDisplay.isThere, "Xvfb is not installed")
    val said = VirtualDisplay.run("frustum.command.Main", 300, "play", "pong", "--frames", "6")
    val rate = """(?s).*6 frames, ([0-9.]+) a second, score 0.*""".r
    said match {
      case rate(perSecond) => assert(perSecond.toDouble > 0, said)
      case _               => fail(said)
    }
  }

  for ((engine, marks) <- Seq("model" -> Nil, "hardware" -> Seq(Simulated)))
    test(s"play voxel shows a world in a window, engine $engine", marks: _*) {
      assume(VirtualDisplay.isThere, "Xvfb is not installed")
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

  test("nothing else can be played") {
    val run = CommandRunner.run("play", "chess")
    assert(run.code == 2 && run.err.head.contains("play voxel"))
  }
}
