package frustum.play

import frustum.model.demos.pong.PongButtons
import java.awt.event.KeyEvent._

/** Buttons of pong from keys, a frame at a time. The hardware takes for pressed what it sees in the blanks before
  * two frames, so that each press is kept for the frame after as well.
  */
final class PongKeys {
  private var before = Set.empty[Int]

  /** @param keys pressed since the frame before, see [[frustum.play.PressedKeys]] */
  def apply(keys: Set[Int]): PongButtons = {
    val down = keys ++ before
    before = keys
    def any(codes: Int*) = codes.exists(down)
    if (any(VK_R)) PongButtons(up = true, down = true, left = true, right = true)
    else PongButtons(any(VK_UP, VK_W), any(VK_DOWN, VK_S), any(VK_LEFT, VK_A), any(VK_RIGHT, VK_D))
  }
}

object PongKeys {
  val help = "keys: arrows or w a s d move the paddle; r starts again; close the window to end"
}
