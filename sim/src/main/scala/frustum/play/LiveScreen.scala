package frustum.play

import frustum.contract.InputError
import java.awt.image.{BufferedImage, DataBufferInt}
import java.awt.{Color, Dimension, Graphics, Graphics2D, GraphicsEnvironment, KeyboardFocusManager, RenderingHints}
import java.util.Locale
import javax.swing.{JFrame, JPanel, SwingUtilities, WindowConstants}
import scala.util.control.NonFatal

/** A window that shows the picture of a simulated system and takes keys and mouse. To be used from the simulation's
  * thread: `show`, then `keys`, until it is no longer `open`.
  *
  * @param scale whole multiple of the picture that the window starts with
  */
final class LiveScreen private (name: String, width: Int, height: Int, scale: Int) extends PlayScreen {
  private val image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
  private val pixels = image.getRaster.getDataBuffer.asInstanceOf[DataBufferInt].getData
  private val rate = new FrameRate
  private val pressed = new PressedKeys
  private val mouse = new PointerListener
  @volatile private var open = true

  private val panel = new JPanel {
    setPreferredSize(new Dimension(width * scale, height * scale))
    setBackground(Color.BLACK)
    override def paintComponent(g: Graphics): Unit = {
      super.paintComponent(g)
      val shown = LiveScreen.fit(width, height, getWidth, getHeight)
      g.asInstanceOf[Graphics2D].setRenderingHint(
        RenderingHints.KEY_INTERPOLATION,
        RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR
      )
      image.synchronized { g.drawImage(image, shown.x, shown.y, shown.width, shown.height, null) }
    }
  }
  private val frame = onEventThread {
    val f = new JFrame(name)
    f.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE)
    f.addWindowListener(new java.awt.event.WindowAdapter {
      override def windowClosed(e: java.awt.event.WindowEvent): Unit = {
        open = false
        KeyboardFocusManager.getCurrentKeyboardFocusManager.removeKeyEventDispatcher(pressed)
      }
    })
    KeyboardFocusManager.getCurrentKeyboardFocusManager.addKeyEventDispatcher(pressed)
    f.addFocusListener(pressed)
    panel.addMouseListener(mouse)
    panel.addMouseMotionListener(mouse)
    panel.addMouseWheelListener(mouse)
    f.setContentPane(panel)
    f.pack()
    f.setLocationByPlatform(true)
    f.setVisible(true)
    // Without a window manager nobody gives a new window the keyboard.
    f.toFront()
    f.requestFocus()
    f
  }

  private def onEventThread[A](body: => A): A = {
    var result = Option.empty[A]
    SwingUtilities.invokeAndWait(() => result = Some(body))
    result.get
  }

  def isOpen: Boolean = open

  def keys(): Set[Int] = pressed.take()
  override def pointer(): PointerMoves = mouse.take()

  def show(rgb: Array[Int], state: String = ""): Unit = {
    image.synchronized { System.arraycopy(rgb, 0, pixels, 0, pixels.length) }
    rate.frame(System.nanoTime)
    val title = LiveScreen.title(name, rate.perSecond, state)
    SwingUtilities.invokeLater { () => frame.setTitle(title); panel.repaint() }
  }

  def framesPerSecond: Double = rate.perSecond

  override def close(): Unit = if (open) onEventThread(frame.dispose())
}

object LiveScreen {
  private val Remedy =
    "set DISPLAY to a graphical screen and use a JDK with its window system (default-jre)"

  /** An error in one line where there is no display: to be called before long work. */
  def require(): Unit =
    if (GraphicsEnvironment.isHeadless) throw InputError(s"there is no display for the window: $Remedy")

  /** Opens the window, or says in one line why there is none. */
  def apply(name: String, width: Int, height: Int, scale: Int = 1): LiveScreen = {
    require()
    try new LiveScreen(name, width, height, scale)
    catch {
      // A JDK without its window system fails to link when it is first used.
      case e @ (_: LinkageError | _: java.awt.AWTError) => throw noWindow(e)
      case NonFatal(e)                                  => throw noWindow(Option(e.getCause).getOrElse(e))
    }
  }

  private def noWindow(e: Throwable) = InputError(s"the window cannot be opened ($e): $Remedy")

  def title(name: String, framesPerSecond: Double, state: String): String =
    s"$name - ${"%.1f".formatLocal(Locale.ROOT, framesPerSecond)} frames/s${if (state.isEmpty) ""
      else s" - $state"}"

  /** The largest rectangle of the picture's shape within the window, in its middle. */
  def fit(width: Int, height: Int, inWidth: Int, inHeight: Int): java.awt.Rectangle = {
    val scale = scala.math.min(inWidth.toDouble / width, inHeight.toDouble / height)
    val (w, h) = ((width * scale).round.toInt, (height * scale).round.toInt)
    new java.awt.Rectangle((inWidth - w) / 2, (inHeight - h) / 2, w, h)
  }
}
