package frustum.play

import frustum.model.demos.pong.PongButtons
import org.scalatest.funsuite.AnyFunSuite

import java.awt.event.KeyEvent._

class PongKeysTest extends AnyFunSuite {
  test("keys are looked at once a tick and held for its two frames") {
    val keys = new PongKeys
    var looks = 0
    def frame(down: Int*) = keys { looks += 1; down.toSet }
    assert(frame(VK_UP) == PongButtons(up = true)) // before the first tick
    assert(frame(VK_A) == PongButtons(left = true))
    assert(frame(VK_RIGHT) == PongButtons(left = true), "the tick's second frame")
    assert(frame() == PongButtons() && frame(VK_S) == PongButtons())
    assert(frame(VK_S) == PongButtons(down = true))
    assert(looks == 4)
  }
  test("r presses all buttons, which starts again") {
    assert((new PongKeys)(Set(VK_R, VK_UP)).restart)
  }
}
