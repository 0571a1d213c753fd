package frustum.play

import frustum.contract.InputError
import org.scalatest.funsuite.AnyFunSuite

import java.awt.event.KeyEvent
import java.awt.{GraphicsEnvironment, Rectangle}

/** What the window does, without one. */
class LiveScreenTest extends AnyFunSuite {
  test("frame rate over the last while") {
    val rate = new FrameRate(1000000000L)
    assert(rate.perSecond == 0)
    for (i <- 0 to 10) rate.frame(i * 100000000L)
    assert((rate.perSecond - 10).abs < 1e-9)
    for (i <- 1 to 30) rate.frame(1000000000L + i * 50000000L)
    assert((rate.perSecond - 20).abs < 1e-9)
  }

  test("a key counts while it is down, and once if it was down only between two looks") {
    val keys = new PressedKeys
    keys.press(KeyEvent.VK_UP)
    assert(keys.take() == Set(KeyEvent.VK_UP) && keys.take() == Set(KeyEvent.VK_UP))
    keys.release(KeyEvent.VK_UP)
    assert(keys.take() == Set())
    keys.press(KeyEvent.VK_LEFT)
    keys.release(KeyEvent.VK_LEFT)
    assert(keys.take() == Set(KeyEvent.VK_LEFT) && keys.take() == Set())
    keys.press(KeyEvent.VK_DOWN)
    keys.take()
    keys.focusLost(null)
    assert(keys.take() == Set())
  }

  test("the picture keeps its shape in a window of any") {
    assert(LiveScreen.fit(640, 480, 1280, 960) == new Rectangle(0, 0, 1280, 960))
    assert(LiveScreen.fit(640, 480, 1000, 480) == new Rectangle(180, 0, 640, 480))
    assert(LiveScreen.fit(640, 480, 320, 480) == new Rectangle(0, 120, 320, 240))
  }

  test("title") {
    assert(LiveScreen.title("pong", 12.34, "") == "pong - 12.3 frames/s")
    assert(LiveScreen.title("pong", 5, "score 3") == "pong - 5.0 frames/s - score 3")
  }

  test("without a display one line tells the remedy") {
    assume(GraphicsEnvironment.isHeadless, "there is a display")
    val e = intercept[InputError](LiveScreen("pong", 64, 48))
    assert(e.message.contains("DISPLAY") && !e.message.contains('\n'))
  }
}
