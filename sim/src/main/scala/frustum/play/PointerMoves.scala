package frustum.play

import java.awt.event.{InputEvent, MouseAdapter, MouseEvent, MouseWheelEvent}

/** Pixels by which the mouse was dragged, with the left button alone and with another or with the shift key; notches
  * of the wheel, towards the user positive.
  */
final case class PointerMoves(
    dragX: Int = 0,
    dragY: Int = 0,
    otherX: Int = 0,
    otherY: Int = 0,
    wheel: Double = 0
)

/** Adds up what the mouse does. */
final class PointerListener extends MouseAdapter {
  private var sum = PointerMoves()
  private var (x, y) = (0, 0)

  def take(): PointerMoves = synchronized {
    val moves = sum
    sum = PointerMoves()
    moves
  }

  override def mousePressed(e: MouseEvent): Unit = synchronized { x = e.getX; y = e.getY }
  override def mouseDragged(e: MouseEvent): Unit = synchronized {
    val (dx, dy) = (e.getX - x, e.getY - y)
    x = e.getX
    y = e.getY
    val left = (e.getModifiersEx & InputEvent.BUTTON1_DOWN_MASK) != 0 && !e.isShiftDown
    sum =
      if (left) sum.copy(dragX = sum.dragX + dx, dragY = sum.dragY + dy)
      else sum.copy(otherX = sum.otherX + dx, otherY = sum.otherY + dy)
  }
  override def mouseWheelMoved(e: MouseWheelEvent): Unit = synchronized {
    sum = sum.copy(wheel = sum.wheel + e.getPreciseWheelRotation)
  }
}
