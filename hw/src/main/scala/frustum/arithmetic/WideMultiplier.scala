package frustum.arithmetic

import frustum.device.Tech
import spinal.core._

/** a b exactly, a signed of up to 31 bits, b unsigned of 16: one multiplier for the lower 15 bits of a and one for the
  * rest, and an adder behind their registers. Latency that of [[Multiplier16]].
  */
case class WideMultiplier(tech: Tech = Tech.Generic, widthA: Int) extends Component {
  require(widthA >= 2 && widthA <= 31, s"WideMultiplier: a of $widthA bits, from 2 to 31")
  val io = new Bundle {
    val a = in SInt (widthA bits)
    val b = in UInt (16 bits)
    val product = out SInt (widthA + 16 bits)
  }
  private def part(a: Bits, signed: Boolean) = {
    val m = Multiplier16(tech, signedA = signed, signedB = false)
    m.io.enable := True
    m.io.a := a
    m.io.b := io.b.asBits
    m.io.product
  }
  if (widthA <= 16) io.product := part(io.a.resize(16).asBits, signed = true).asSInt.resized
  else {
    val high = part((io.a >> 15).resize(16).asBits, signed = true).asSInt
    val low = part(io.a(14 downto 0).asBits.resized, signed = false)
    io.product := ((high + (B(
      0,
      1 bits
    ) ## low(31 downto 15)).asSInt.resize(32 bits)) ## low(14 downto 0)).asSInt.resized
  }
}
