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
    val slow = new FrameRate(1000000000L)
    for (i <- 0 to 2) slow.frame(i * 7000000000L)
    assert((slow.perSecond - 1.0 / 7).abs < 1e-9, "seconds from frame to frame")
  }

  test("a key counts while it is down, and once if it was down only between two looks") {
    val keys = new PressedKeys
    keys.press(KeyEvent.VK_UP, 0)
    assert(keys.take() == Set(KeyEvent.VK_UP) && keys.take() == Set(KeyEvent.VK_UP))
    keys.release(KeyEvent.VK_UP, 100)
    assert(keys.take() == Set())
    keys.press(KeyEvent.VK_LEFT, 200)
    keys.release(KeyEvent.VK_LEFT, 210)
    assert(keys.take() == Set(KeyEvent.VK_LEFT) && keys.take() == Set())
    keys.press(KeyEvent.VK_DOWN, 300)
    keys.take()
    keys.focusLost(null)
    assert(keys.take() == Set())
  }

  test("a key pressed several times between two looks is seen down as often, and up in between") {
    val keys = new PressedKeys
    for (n <- 0 until 3) {
      keys.press(KeyEvent.VK_E, 100L * n)
      keys.release(KeyEvent.VK_E, 100L * n + 40)
    }
    def seen = keys.take().contains(KeyEvent.VK_E)
    assert(Seq.fill(7)(seen) == Seq(true, false, true, false, true, false, false))
    // Released and pressed again while it was seen as down.
    keys.press(KeyEvent.VK_E, 1000)
    assert(seen)
    keys.release(KeyEvent.VK_E, 1050)
    keys.press(KeyEvent.VK_E, 1100)
    assert(Seq.fill(4)(seen) == Seq(false, true, true, true))
    keys.release(KeyEvent.VK_E, 1200)
    assert(!seen)
  }

  test("the keyboard's repetition of a key that is held is no press") {
    val keys = new PressedKeys
    keys.press(KeyEvent.VK_UP, 0)
    for (at <- 500L to 2000L by 30L) { keys.release(KeyEvent.VK_UP, at); keys.press(KeyEvent.VK_UP, at) }
    assert(Seq.fill(5)(keys.take()).forall(_ == Set(KeyEvent.VK_UP)))
    keys.release(KeyEvent.VK_UP, 2010)
    assert(keys.take() == Set())
  }

  test("frames come at their pace, and one that is late is not made up for") {
    var now = 0L
    val slept = scala.collection.mutable.ArrayBuffer.empty[Long]
    val pace = new Pace(50, () => now, nanos => { slept += nanos; now += nanos })
    val millis = 1000000L
    pace.await()
    for (work <- Seq(5, 15, 20)) { now += work * millis; pace.await() }
    assert(slept.toSeq == Seq(15 * millis, 5 * millis))
    now += 30 * millis // ten late
    pace.await()
    now += 5 * millis
    pace.await()
    assert(slept.last == 5 * millis, "the next is in time again")
    now += 500 * millis
    pace.await()
    now += 1 * millis
    pace.await()
    assert(slept.last == 19 * millis, "no hurry after a long halt")
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
