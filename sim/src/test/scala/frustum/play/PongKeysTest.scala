package frustum.play

import frustum.model.demos.pong.PongButtons
import org.scalatest.funsuite.AnyFunSuite

import java.awt.event.KeyEvent._

class PongKeysTest extends AnyFunSuite {
  test("a press holds for two frames") {
    val keys = new PongKeys
    assert(keys(Set(VK_UP)) == PongButtons(up = true))
    assert(keys(Set(VK_A)) == PongButtons(up = true, left = true))
    assert(keys(Set()) == PongButtons(left = true) && keys(Set()) == PongButtons())
  }
  test("r presses all buttons, which starts again") {
    assert((new PongKeys)(Set(VK_R, VK_UP)).restart)
  }
}
