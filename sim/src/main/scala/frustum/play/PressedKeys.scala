package frustum.play

import java.awt.KeyEventDispatcher
import java.awt.event.{FocusEvent, FocusListener, KeyEvent}
import scala.collection.mutable

/** Which keys are down, by their `KeyEvent` codes, from look to look. However briefly a key was pressed, one look sees
  * it
  * down; pressed twice between two looks it is seen down, up and down again. All keys are up when the window loses the
  * keyboard, for their release is then told to another.
  *
  * A dispatcher takes the keys of the whole program, whichever part of the window has the focus.
  */
final class PressedKeys extends KeyEventDispatcher with FocusListener {
  import PressedKeys._
  private final class Key {
    var down = false
    var presses = 0 // no look has seen yet
    var seen = false // down at the last look
    var released = Long.MinValue / 2 // when, milliseconds
  }
  private val all = mutable.Map.empty[Int, Key]

  /** A look. */
  def take(): Set[Int] = synchronized {
    all.collect { case (code, key) if look(key) => code }.toSet
  }

  private def look(key: Key): Boolean = {
    if (key.presses == 0) key.seen = key.down
    else {
      // Between two presses it was up.
      if (!key.seen) key.presses -= 1
      key.seen = !key.seen
    }
    key.seen
  }

  /** @param millis when; a press right after a release is the keyboard's repetition of a key that is held, as X tells
    * it
    */
  def press(code: Int, millis: Long): Unit = synchronized {
    val key = all.getOrElseUpdate(code, new Key)
    if (!key.down && millis - key.released > RepeatMillis) key.presses += 1
    key.down = true
  }
  def release(code: Int, millis: Long): Unit = synchronized {
    for (key <- all.get(code)) {
      key.down = false
      key.released = millis
    }
  }
  def releaseAll(): Unit = synchronized(all.clear())

  def dispatchKeyEvent(e: KeyEvent): Boolean = {
    e.getID match {
      case KeyEvent.KEY_PRESSED  => press(e.getKeyCode, e.getWhen)
      case KeyEvent.KEY_RELEASED => release(e.getKeyCode, e.getWhen)
      case _                     =>
    }
    false
  }
  def focusGained(e: FocusEvent): Unit = ()
  def focusLost(e: FocusEvent): Unit = releaseAll()
}

object PressedKeys {

  /** A finger takes ten times as long between two presses; the two events of a repetition have the same time. */
  private val RepeatMillis = 2L
}
