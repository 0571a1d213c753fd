package frustum.play

import frustum.model.demos.voxel.VoxelButtons
import java.awt.event.KeyEvent._

/** A player's buttons from keys. */
object VoxelKeys {
  val help =
    "keys: w a s d walk, arrows look, space jumps or rises, shift sinks, q e change the item, c places, x destroys; " +
      "close the window to end"

  def apply(keys: Set[Int]): VoxelButtons = VoxelButtons(
    forward = keys(VK_W),
    back = keys(VK_S),
    left = keys(VK_A),
    right = keys(VK_D),
    up = keys(VK_SPACE),
    down = keys(VK_SHIFT),
    turnLeft = keys(VK_LEFT),
    turnRight = keys(VK_RIGHT),
    lookUp = keys(VK_UP),
    lookDown = keys(VK_DOWN),
    next = keys(VK_E),
    previous = keys(VK_Q),
    place = keys(VK_C),
    destroy = keys(VK_X)
  )
}
