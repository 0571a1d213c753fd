package frustum.play

import frustum.demos.pong.PongRules
import frustum.model.demos.pong.PongButtons
import java.awt.event.KeyEvent._

/** Buttons of pong from keys, a frame at a time. The hardware takes for pressed what it sees in the blanks before two
  * frames:
  * keys are looked at once a tick, and held for its frames.
  */
final class PongKeys {
  private var frame = 0
  private var held = PongButtons()

  /** @param keys a look at them, see [[frustum.play.PressedKeys]]; not taken in a tick's second frame */
  def apply(keys: => Set[Int]): PongButtons = {
    if (frame == 0 || frame % PongRules.FramesPerTick == 1) held = buttons(keys)
    frame += 1
    held
  }

  private def buttons(down: Set[Int]): PongButtons = {
    def any(codes: Int*) = codes.exists(down)
    if (any(VK_R)) PongButtons(up = true, down = true, left = true, right = true)
    else PongButtons(any(VK_UP, VK_W), any(VK_DOWN, VK_S), any(VK_LEFT, VK_A), any(VK_RIGHT, VK_D))
  }
}

object PongKeys {
  val help = "keys: arrows or w a s d move the paddle; r starts again; close the window to end"
}
