package frustum.play

import java.awt.event.{InputEvent, KeyEvent}
import java.awt.{Rectangle, Robot}

/** Shows a picture, presses keys, looks at the screen, closes the window; prints what it saw. */
object LiveScreenProbe {
  def main(args: Array[String]): Unit = {
    val (width, height) = (64, 48)
    val screen = LiveScreen("probe", width, height, scale = 2)
    val robot = new Robot
    val picture = Array.tabulate(width * height)(i => if (i % width < width / 2) 0xc02040 else 0x1080f0)
    def until(done: => Boolean): Boolean = (1 to 100).exists { _ =>
      screen.show(picture, "state")
      Thread.sleep(50)
      done
    }
    def shot = robot.createScreenCapture(new Rectangle(0, 0, 1024, 768))
    def seen = {
      val s = shot; (for (y <- 0 until 768; x <- 0 until 1024) yield s.getRGB(x, y) & 0xffffff).toArray
    }
    println("picture " + until {
      val s = seen
      s.count(_ == 0xc02040) == width * height * 2 && s.count(_ == 0x1080f0) == width * height * 2
    })
    // Without a window manager nobody but the window itself asks for the keyboard; the mouse is elsewhere.
    robot.mouseMove(1000, 740)
    Thread.sleep(200)
    robot.keyPress(KeyEvent.VK_UP)
    println("pressed " + until(screen.keys().contains(KeyEvent.VK_UP)))
    robot.keyRelease(KeyEvent.VK_UP)
    println("released " + until(!screen.keys().contains(KeyEvent.VK_UP)))
    val at = seen.indexOf(0xc02040)
    val (x, y) = (at % 1024 + 20, at / 1024 + 20)
    screen.pointer()
    var moves = PointerMoves()
    robot.mouseMove(x, y)
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
    robot.mouseMove(x + 12, y + 7)
    println("dragged " + until {
      val more = screen.pointer()
      moves = moves.copy(dragX = moves.dragX + more.dragX, dragY = moves.dragY + more.dragY)
      moves == PointerMoves(dragX = 12, dragY = 7)
    })
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
    robot.mouseWheel(2)
    println("wheel " + until(screen.pointer().wheel > 0))
    println("rate " + (screen.framesPerSecond > 1))
    screen.close()
    println("closed " + until(!screen.isOpen))
  }
}
