package frustum.play

import java.awt.event.KeyEvent
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
    // Without a window manager nothing gives the window the keyboard but the mouse.
    val s = seen
    val at = s.indexOf(0xc02040)
    robot.mouseMove(at % 1024 + 10, at / 1024 + 10)
    robot.keyPress(KeyEvent.VK_UP)
    println("pressed " + until(screen.keys().contains(KeyEvent.VK_UP)))
    robot.keyRelease(KeyEvent.VK_UP)
    println("released " + until(!screen.keys().contains(KeyEvent.VK_UP)))
    println("rate " + (screen.framesPerSecond > 1))
    screen.close()
    println("closed " + until(!screen.isOpen))
  }
}
