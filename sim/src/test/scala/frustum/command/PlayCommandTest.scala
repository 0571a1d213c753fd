package frustum.command

import frustum.live.VirtualDisplay
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

  test("play pong shows frames of the simulated hardware in a window") {
    assume(VirtualDisplay.isThere, "Xvfb is not installed")
    val said = VirtualDisplay.run("frustum.command.Main", 300, "play", "pong", "--frames", "6")
    val rate = """(?s).*6 frames, ([0-9.]+) a second, score 0.*""".r
    said match {
      case rate(perSecond) => assert(perSecond.toDouble > 0, said)
      case _               => fail(said)
    }
  }
}
