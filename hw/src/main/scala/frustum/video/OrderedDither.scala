package frustum.video

import frustum.contract.video.{Bayer, ColorFormat}
import spinal.core._
import spinal.lib.graphic.{Rgb, RgbConfig}

/** Eight-bit channels to a display's own with ordered dither: channel of n bits = (c - (c >> n) + threshold) >> (8 -
  * n), which keeps 0 and 255 at the ends of the range and never overflows. Combinational; 8 bits stay as they are.
  */
case class OrderedDither(format: ColorFormat) extends Component {
  val io = new Bundle {
    val rgb = in(Rgb(RgbConfig(8, 8, 8)))
    val x, y = in UInt (2 bits) // the pixel's position modulo 4
    val red = out UInt (format.red bits)
    val green = out UInt (format.green bits)
    val blue = out UInt (format.blue bits)
  }
  private def channel(c: UInt, bits: Int): UInt = {
    val lost = 8 - bits
    if (lost == 0) c
    else {
      val thresholds = Vec(for (y <- 0 to 3; x <- 0 to 3) yield U(Bayer.threshold(x, y, lost), 8 bits))
      (c - (c |>> bits) + thresholds(io.y @@ io.x))(7 downto lost)
    }
  }
  io.red := channel(io.rgb.r, format.red)
  io.green := channel(io.rgb.g, format.green)
  io.blue := channel(io.rgb.b, format.blue)
}
