package frustum.video

import frustum.contract.video.{ColorFormat, Crosshair, TextField, VideoMode}
import spinal.core._
import spinal.lib._

/** A picture from a frame buffer to a monitor, each of its pixels 2^scale wide and high, with text and a crosshair over
  * it: letters are white and their cells at half brightness, the crosshair inverts. It runs at the pixel clock, or with
  * a clock enable at that rate.
  *
  * `address` reads the frame buffer, whose data must come before the next pixel. `blank` is high for a pixel after the
  * last row.
  */
case class DoubledScanout(mode: VideoMode, format: ColorFormat, scale: Int, fields: Seq[TextField]) extends Component {
  require(
    mode.width % (1 << scale) == 0 && mode.height % (1 << scale) == 0,
    s"mode ${mode.name}: ${mode.width} x ${mode.height} is not a multiple of ${1 << scale}"
  )
  private val (width, height) = (mode.width >> scale, mode.height >> scale)
  val io = new Bundle {
    val address = out UInt (log2Up(width * height) bits)
    val color = in Bits (format.bits bits)
    val marked = in Bool () // text and crosshair are shown
    val text = in(TextOverlay.text(fields))
    val blank = out Bool ()
    val video = master(VideoBus(format))
  }
  val scanner = PixelScanner(mode)
  val (x, y) = (scanner.io.x >> scale, scanner.io.y >> scale)
  val row = Reg(UInt(log2Up(width * height) bits)) init 0 // address of its first pixel
  val lastLine = scanner.io.y(scale - 1 downto 0).andR
  when(scanner.io.line) {
    when(scanner.io.y === mode.vTotal - 1)(row := 0) elsewhen (lastLine)(row := row + width)
  }
  io.address := RegNext(row + x.resized)
  io.blank := scanner.io.frameEnd

  val overlay = TextOverlay(fields, log2Up(mode.hTotal max mode.vTotal))
  overlay.io.x := scanner.io.x.resized
  overlay.io.y := scanner.io.y.resized
  overlay.io.text := io.text
  overlay.io.shown := Repeat(io.marked, fields.length)

  val crossed = {
    val cross = Crosshair(width, height)
    def near(v: UInt, at: Int) = v >= at - Crosshair.Arm && v <= at + Crosshair.Arm
    val arms = RegNext(x === cross.x) && RegNext(near(y, cross.y)) ||
      RegNext(y === cross.y) && RegNext(near(x, cross.x))
    Delay(arms && io.marked, TextOverlay.Latency - 1)
  }

  /** Colours come as late as the text, the pins one register later. */
  val color = Delay(io.color, TextOverlay.Latency - 1)
  private val before = Delay(scanner.io.active, TextOverlay.Latency, init = False)
  private def late(pulse: Bool, idle: Bool) = Delay(pulse, TextOverlay.Latency + 1, init = idle)

  private def channel(of: Bits): UInt = {
    val crossing = Mux(crossed, ~of, of)
    val written =
      Mux(overlay.io.dot, B(of.getWidth bits, default -> True), Mux(overlay.io.cell, crossing |>> 1, crossing))
    RegNext(Mux(before, written, B(0, of.getWidth bits))).asUInt
  }
  io.video.red := channel(color(format.bits - 1 downto format.green + format.blue))
  io.video.green := channel(color(format.green + format.blue - 1 downto format.blue))
  io.video.blue := channel(color(format.blue - 1 downto 0))
  io.video.active := late(scanner.io.active, False)
  io.video.hSync := late(scanner.io.hSync, Bool(!mode.hPositive))
  io.video.vSync := late(scanner.io.vSync, Bool(!mode.vPositive))
}
