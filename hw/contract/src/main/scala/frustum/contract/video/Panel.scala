package frustum.contract.video

/** A command of a display controller with its parameters. */
final case class PanelCommand(code: Int, parameters: Int*)

/** A serial display of 240 x 320 pixels, driven in 16-bit colour (RGB565).
  *
  * @param start what to send after reset, in order; the first is "sleep out", after which the panel wants to be left
  *              alone for [[Panel.SettleMs]], as it does after reset
  * @param portrait,landscape parameter of the memory access control command that makes rows run across the screen
  *              as it is held: upright, or turned a quarter clockwise
  */
sealed abstract class Panel(
    val name: String,
    val portrait: Int,
    val landscape: Int,
    val extra: Seq[PanelCommand]
) {

  /** Whether a screen of this size is shown in landscape; it starts at the panel's top left corner. */
  def isLandscape(config: ScreenTiles): Boolean = {
    import config.{height, width}
    require(
      width.min(height) <= Panel.ShortSide && width.max(height) <= Panel.LongSide,
      s"$name: a screen of $width x $height does not fit ${Panel.ShortSide} x ${Panel.LongSide} either way"
    )
    width > Panel.ShortSide
  }

  def start(config: ScreenTiles): Seq[PanelCommand] =
    Seq(
      PanelCommand(Panel.SleepOut),
      PanelCommand(Panel.PixelFormat, 0x55),
      PanelCommand(Panel.MemoryAccess, if (isLandscape(config)) landscape else portrait)
    ) ++ extra :+ PanelCommand(Panel.DisplayOn)
}

object Panel {
  val ShortSide = 240
  val LongSide = 320

  /** Both data sheets: 120 ms from the end of reset to sleep out; the same is given after sleep out. */
  val SettleMs = 120

  // Bits of memory access control.
  val MirrorY = 0x80
  val MirrorX = 0x40
  val Exchange = 0x20
  val Bgr = 0x08

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
  case object Ili9341 extends Panel("ili9341", portrait = MirrorX | Bgr, landscape = Exchange | Bgr, extra = Nil)

  /** Sitronix ST7789 on an IPS glass, which wants inverted data. Its data sheet allows 62.5 MHz of SCK. */
  case object St7789
      extends Panel("st7789", portrait = 0, landscape = Exchange | MirrorX, extra = Seq(PanelCommand(InversionOn)))

  def all: Seq[Panel] = Seq(Ili9341, St7789)
}
