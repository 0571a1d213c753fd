package frustum.play

import java.awt.event.{FocusEvent, FocusListener, KeyEvent, KeyListener}

/** Which keys are down, by their `KeyEvent` codes. All are up when the window loses the keyboard, for their
  * release is then told to another.
  */
final class PressedKeys extends KeyListener with FocusListener {
  @volatile private var down = Set.empty[Int]
  @volatile private var typed = Set.empty[Int]

  /** A key counts until it was seen once, however briefly it was pressed. */
  def take(): Set[Int] = synchronized {
    val seen = down ++ typed
    typed = Set.empty
    seen
  }

  def press(code: Int): Unit = synchronized { down += code; typed += code }
  def release(code: Int): Unit = synchronized { down -= code }
  def releaseAll(): Unit = synchronized { down = Set.empty }

  def keyPressed(e: KeyEvent): Unit = press(e.getKeyCode)
  def keyReleased(e: KeyEvent): Unit = release(e.getKeyCode)
  def keyTyped(e: KeyEvent): Unit = ()
  def focusGained(e: FocusEvent): Unit = ()
  def focusLost(e: FocusEvent): Unit = releaseAll()
}
