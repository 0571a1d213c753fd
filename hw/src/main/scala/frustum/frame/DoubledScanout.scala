package frustum.frame

import frustum.display.{PixelScanner, VideoBus}
import frustum.spec.{ColorFormat, VideoMode}
import spinal.core._
import spinal.lib._

/** A picture of half a video mode's width and height from a frame buffer to a monitor, each pixel four times. It runs at the pixel clock,
  * or with a clock enable at that rate.
  *
  * `address` asks the frame buffer, whose answer must come before the next pixel. `blank` is high for a pixel after the last row.
  */
case class DoubledScanout(mode: VideoMode, format: ColorFormat) extends Component {
  require(
    mode.width % 2 == 0 && mode.height % 2 == 0,
    s"mode ${mode.name}: ${mode.width} x ${mode.height} cannot be halved"
  )
  val pixels: Int = mode.width * mode.height / 4
  val io          = new Bundle {
    val address = out UInt (log2Up(pixels) bits)
    val color   = in Bits (format.bits bits)
    val blank   = out Bool ()
    val video   = master(VideoBus(format))
  }
  val scanner = PixelScanner(mode)
  val row     = Reg(UInt(log2Up(pixels) bits)) init 0 // address of its first pixel
  when(scanner.io.line) {
    row := row + mode.width / 2
    when(scanner.io.y === mode.vTotal - 1)(row := 0) elsewhen (!scanner.io.y(0))(row := row)
  }
  io.address := RegNext(row + (scanner.io.x >> 1).resized)
  io.blank   := scanner.io.frameEnd

  private def late(b: Bool, idle: Boolean) = Delay(b, 2, init = Bool(idle))
  val active                               = late(scanner.io.active, idle = false)
  val color                                = RegNext(io.color)
  private val Seq(red, green, blue)        = {
    val shown = Mux(active, color, B(0, format.bits bits)).asUInt
    Seq(
      shown(format.bits - 1 downto format.green + format.blue),
      shown(format.green + format.blue - 1 downto format.blue),
      shown(format.blue - 1 downto 0)
    )
  }
  io.video.red    := red
  io.video.green  := green
  io.video.blue   := blue
  io.video.active := active
  io.video.hSync  := late(scanner.io.hSync, !mode.hPositive)
  io.video.vSync  := late(scanner.io.vSync, !mode.vPositive)
}
