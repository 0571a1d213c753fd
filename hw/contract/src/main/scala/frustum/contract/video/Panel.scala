package frustum.contract.video

/** A command of a display controller with its parameters. */
final case class PanelCommand(code: Int, parameters: Int*)

/** A serial display in 16-bit colour (RGB565): a controller with a memory of 240 x 320 pixels, and a glass that shows
  * a part of it.
  *
  * @param mirrored   the glass is wired right to left
  * @param blueFirst  order of its colour filter
  * @param inverted   it needs inverted data
  * @param glass      the part of the memory that is visible
  * @param selectPin  whether the module has a chip select; without one SCK must rest high (SPI mode 3)
  * @param turned     quarter turns, clockwise, by which the module is mounted
  */
final case class Panel(
    name: String,
    mirrored: Boolean,
    blueFirst: Boolean,
    inverted: Boolean,
    glass: PanelGlass = PanelGlass(0, 0, Panel.ShortSide, Panel.LongSide),
    selectPin: Boolean = true,
    turned: Int = 0
) {
  require(turned >= 0 && turned < 4, s"$name: turned by $turned quarters; 0 to 3")
  import Panel._

  /** The same module mounted `quarters` further, clockwise. */
  def turnedBy(quarters: Int): Panel =
    copy(name = s"$name-turned${if (quarters == 2) "" else s"-$quarters"}", turned = (turned + quarters) & 3)

  /** Why a screen of this size cannot be shown, or None. */
  def fault(width: Int, height: Int): Option[String] =
    if (width.min(height) <= glass.width.min(glass.height) && width.max(height) <= glass.width.max(glass.height)) None
    else Some(s"$name: a screen of $width x $height does not fit ${glass.width} x ${glass.height} either way")

  /** Quarters, clockwise, by which the picture is turned on the glass: as mounted, or one more if only that fits. */
  private def quarters(config: ScreenTiles): Int = {
    fault(config.width, config.height).foreach(f => throw new IllegalArgumentException(f))
    val (across, down) = if (turned % 2 == 0) (glass.width, glass.height) else (glass.height, glass.width)
    if (config.width <= across && config.height <= down) turned else (turned + 1) & 3
  }

  /** Memory access control: the direction of rows in the memory. */
  private def access(config: ScreenTiles): Int =
    Quarters(quarters(config)) ^ (if (mirrored) MirrorX else 0) | (if (blueFirst) Bgr else 0)

  /** Column and row, in the controller's numbers, of the screen's top left pixel, which is the glass's corner. */
  def origin(config: ScreenTiles): (Int, Int) = {
    // Glass wired right to left shows the memory's columns from the other end.
    val left = if (mirrored) ShortSide - glass.x - glass.width else glass.x
    val bits = access(config)
    val column = if ((bits & MirrorX) != 0) ShortSide - left - glass.width else left
    val row = if ((bits & MirrorY) != 0) LongSide - glass.y - glass.height else glass.y
    if ((bits & Exchange) != 0) (row, column) else (column, row)
  }

  /** What to send after reset, in order; the first is "sleep out", after which nothing may be sent for
    * [[Panel.SettleMs]], as it does after reset.
    */
  def start(config: ScreenTiles): Seq[PanelCommand] = {
    val inversion = if (inverted) Seq(PanelCommand(InversionOn)) else Nil
    Seq(
      PanelCommand(SleepOut),
      PanelCommand(PixelFormat, 0x55),
      PanelCommand(MemoryAccess, access(config))
    ) ++ inversion :+ PanelCommand(DisplayOn)
  }
}

/** The part of a controller's memory that a glass shows, upright: its first column and row, and its size. */
final case class PanelGlass(x: Int, y: Int, width: Int, height: Int)

object Panel {

  /** Of the controllers' memories. */
  val ShortSide = 240
  val LongSide = 320

  /** Both data sheets: 120 ms from the end of reset to sleep out; the same is given after sleep out. */
  val SettleMs = 120

  // Bits of memory access control.
  val MirrorY = 0x80
  val MirrorX = 0x40
  val Exchange = 0x20
  val Bgr = 0x08

  /** Memory access control for a picture turned by 0 to 3 quarters clockwise, on glass wired left to right. */
  private val Quarters = Seq(0, Exchange | MirrorX, MirrorX | MirrorY, Exchange | MirrorY)

  val SleepOut = 0x11
  val NormalMode = 0x13
  val InversionOff = 0x20
  val InversionOn = 0x21
  val DisplayOff = 0x28
  val DisplayOn = 0x29
  val ColumnAddress = 0x2a
  val RowAddress = 0x2b
  val MemoryWrite = 0x2c
  val MemoryAccess = 0x36
  val PixelFormat = 0x3a

  /** Ilitek ILI9341: glass wired right to left, colour filter blue first. Its data sheet allows 10 MHz of SCK. */
  val Ili9341: Panel = Panel("ili9341", mirrored = true, blueFirst = true, inverted = false)

  /** Sitronix ST7789 on an IPS glass, which needs inverted data. Its data sheet allows 62.5 MHz of SCK. */
  val St7789: Panel = Panel("st7789", mirrored = false, blueFirst = false, inverted = true)

  /** Modules of 1.3 inches with seven pins: no chip select, the first 240 rows of the memory. */
  val St7789Square: Panel =
    St7789.copy(name = "st7789-240x240", glass = PanelGlass(0, 0, 240, 240), selectPin = false)

  /** The same mounted upside down: the visible part begins at row 80. */
  val St7789SquareTurned: Panel = St7789Square.turnedBy(2)

  /** 1.69 inches: 20 rows are hidden at either end. */
  val St7789Round: Panel = St7789.copy(name = "st7789-240x280", glass = PanelGlass(0, 20, 240, 280))

  /** 1.14 inches: 52 columns are hidden on one side and 53 on the other, 40 rows at either end. */
  val St7789Small: Panel = St7789.copy(name = "st7789-135x240", glass = PanelGlass(52, 40, 135, 240))

  /** Those that show the whole memory. */
  val whole: Seq[Panel] = Seq(Ili9341, St7789)
  val all: Seq[Panel] = whole ++ Seq(St7789Square, St7789SquareTurned, St7789Round, St7789Small)
}
