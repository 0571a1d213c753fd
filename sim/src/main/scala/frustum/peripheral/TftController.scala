package frustum.peripheral

import frustum.contract.video.Panel
import scala.collection.mutable.ArrayBuffer

/** What the maker of a module has connected to its controller, from the modules' drawings; of the memory's 240 columns
  * and 320 rows the glass shows those from `column` and `row` on, held upright.
  *
  * @param mirrored the memory's first column is on the right
  * @param bgr      the glass has blue where the controller puts red
  * @param negative the glass is light where the controller puts dark
  */
final case class TftGlass(
    column: Int,
    row: Int,
    width: Int,
    height: Int,
    mirrored: Boolean = false,
    bgr: Boolean = false,
    negative: Boolean = true
)

object TftGlass {

  /** By the panel's name; how a module is mounted is no matter of its glass. */
  def of(panel: String): TftGlass = panel.replaceFirst("-turned.*", "") match {
    case "ili9341"        => TftGlass(0, 0, 240, 320, mirrored = true, bgr = true, negative = false)
    case "st7789"         => TftGlass(0, 0, 240, 320)
    case "st7789-240x240" => TftGlass(0, 0, 240, 240)
    case "st7789-240x280" => TftGlass(0, 20, 240, 280)
    case "st7789-135x240" => TftGlass(52, 40, 135, 240)
  }
}

/** An ILI9341 or ST7789 with its memory of 240 x 320 pixels, fed with the bytes of its serial port and their times.
  *
  * It obeys the commands it knows and writes down in `violations` what a real controller would not put up with: unknown
  * commands, missing or surplus parameters, pixels before display on, commands too soon after reset or sleep out.
  * [[picture]] is what an observer sees, with the glass's wiring, colour filter order and polarity taken into account:
  * a wrong initialisation shows as a mirrored, blue-for-red or negative picture.
  */
final class TftController(panel: Panel) {
  import Panel._
  private val columns = 240
  private val pages = 320
  private val memory = Array.fill(columns * pages)(0)

  private val glass = TftGlass.of(panel.name)

  val violations = ArrayBuffer.empty[String]

  /** Pixels written since reset. */
  var pixels = 0L

  private var access, format = 0
  private var inverted, awake, on = false
  private var (x0, x1, y0, y1) = (0, 0, 0, 0)
  private var (column, row) = (0, 0)
  private var notBeforeMs = Double.PositiveInfinity
  private var command = -1
  private val parameters = ArrayBuffer.empty[Int]

  private def violation(what: String): Unit = violations += what

  /** The reset pin has been low for `lowMs` and rises at `timeMs`. */
  def reset(timeMs: Double, lowMs: Double): Unit = {
    if (lowMs < TftController.ResetLowMs)
      violation(f"reset low for $lowMs%.4f ms, at least ${TftController.ResetLowMs}%.2f")
    access = 0
    format = 0x66
    inverted = false
    awake = false
    on = false
    x0 = 0; x1 = columns - 1; y0 = 0; y1 = pages - 1
    command = -1
    parameters.clear()
    notBeforeMs = timeMs + SettleMs
  }

  /** A byte, complete at `timeMs`, with the level of D/C at its last bit. */
  def byte(data: Boolean, value: Int, timeMs: Double): Unit =
    if (data) takeData(value) else takeCommand(value, timeMs)

  /** SCK has been low for long between two bytes. Modules whose chip select is tied low are specified for SPI
    * mode 3, in which the line rests high.
    */
  def restedLow(): Unit = violation("SCK rests low: a module without chip select wants SPI mode 3")

  private def takeCommand(code: Int, timeMs: Double): Unit = {
    finish()
    if (timeMs < notBeforeMs) {
      val wait = if (notBeforeMs.isInfinite) "without a reset" else f"${notBeforeMs - timeMs}%.1f ms too soon"
      violation(f"command 0x$code%02x $wait")
      notBeforeMs = 0
    }
    command = code
    if (!TftController.Parameters.contains(code) && code != MemoryWrite) violation(f"unknown command 0x$code%02x")
    code match {
      case SleepOut     => awake = true; notBeforeMs = timeMs + SettleMs
      case InversionOn  => inverted = true
      case InversionOff => inverted = false
      case DisplayOn    => on = true; if (!awake) violation("display on before sleep out")
      case DisplayOff   => on = false
      case MemoryWrite  =>
        column = x0
        row = y0
        if (!on) violation("memory write before display on")
        if (format != 0x55) violation(f"memory write in pixel format 0x$format%02x, not 0x55")
      case _ =>
    }
  }

  /** Looks back at the command that ends. */
  private def finish(): Unit = if (command >= 0) {
    val due = TftController.Parameters.get(command)
    due.filter(_ != parameters.length).foreach(n =>
      violation(f"command 0x$command%02x with ${parameters.length} bytes, not $n")
    )
    if (command == MemoryWrite && parameters.nonEmpty) violation("memory write ends in half a pixel")
    parameters.clear()
    command = -1
  }

  private def takeData(value: Int): Unit = {
    parameters += value
    def word(i: Int) = parameters(i) << 8 | parameters(i + 1)
    command match {
      case -1            => violation(f"data 0x$value%02x without a command")
      case PixelFormat   => format = value
      case MemoryAccess  => access = value
      case ColumnAddress => if (parameters.length == 4) { x0 = word(0); x1 = word(2); window("columns", x0, x1, width) }
      case RowAddress    => if (parameters.length == 4) { y0 = word(0); y1 = word(2); window("rows", y0, y1, height) }
      case MemoryWrite   => if (parameters.length == 2) { write(word(0)); parameters.clear() }
      case _             =>
    }
  }

  private def exchange = (access & Exchange) != 0
  private def width = if (exchange) pages else columns
  private def height = if (exchange) columns else pages

  private def window(what: String, first: Int, last: Int, limit: Int): Unit =
    if (first > last || last >= limit) violation(s"$what $first to $last of $limit")

  private def write(color: Int): Unit = {
    val (c, p) = if (exchange) (row, column) else (column, row)
    val physical =
      (if ((access & MirrorX) != 0) columns - 1 - c else c, if ((access & MirrorY) != 0) pages - 1 - p else p)
    physical match {
      case (x, y) if x >= 0 && x < columns && y >= 0 && y < pages => memory(y * columns + x) = color
      case _                                                      =>
    }
    pixels += 1
    if (column < x1) column += 1
    else {
      column = x0
      row = if (row < y1) row + 1 else y0
    }
  }

  /** The top left `width` x `height` pixels of the glass as RGB565 rows from the top. Black while asleep or off.
    *
    * @param quarters clockwise, by which the viewer holds the module turned
    */
  def picture(width: Int, height: Int, quarters: Int): Array[Int] = Array.tabulate(width * height) { i =>
    val (x, y) = (i % width, i / width)
    val (gx, gy) = quarters match {
      case 0 => (x, y)
      case 1 => (glass.width - 1 - y, x)
      case 2 => (glass.width - 1 - x, glass.height - 1 - y)
      case 3 => (y, glass.height - 1 - x)
    }
    val column = if (glass.mirrored) columns - 1 - glass.column - gx else glass.column + gx
    if (on && awake) seen(memory((glass.row + gy) * columns + column)) else 0
  }

  /** The same, held as the module is mounted or, where the picture would not fit so, a quarter further clockwise. */
  def picture(width: Int, height: Int): Array[Int] = {
    val (across, down) = if (panel.turned % 2 == 0) (glass.width, glass.height) else (glass.height, glass.width)
    picture(width, height, if (width > across || height > down) (panel.turned + 1) % 4 else panel.turned)
  }

  private def seen(stored: Int): Int = {
    val swapped = ((access & Bgr) != 0) != glass.bgr
    val color = if (swapped) (stored & 0x7e0) | stored >> 11 | (stored & 31) << 11 else stored
    if (inverted != glass.negative) color ^ 0xffff else color
  }
}

object TftController {
  import Panel._

  /** Least length of a reset pulse in both data sheets: 10 us. */
  val ResetLowMs = 0.01

  /** Parameter bytes of the commands it knows. */
  val Parameters: Map[Int, Int] = Map(
    SleepOut -> 0,
    NormalMode -> 0,
    InversionOff -> 0,
    InversionOn -> 0,
    DisplayOff -> 0,
    DisplayOn -> 0,
    ColumnAddress -> 4,
    RowAddress -> 4,
    MemoryAccess -> 1,
    PixelFormat -> 1
  )
}
