package frustum.fixed

import frustum.blackbox.{Mac16, Tech}
import spinal.core._

/** 16 x 16 -> 32 bit product, exact, latency two clocks of `enable`: operands are registered, then the product.
  * While `enable` is low both stages hold, so it stalls with a pipeline. On iCE40 it is one SB_MAC16.
  *
  * @param signedA,signedB whether that operand is two's complement; the product is, if either operand is
  */
case class Multiplier16(tech: Tech, signedA: Boolean, signedB: Boolean) extends Component {
  val io = new Bundle {
    val enable  = in Bool ()
    val a, b    = in Bits (16 bits)
    val product = out Bits (32 bits)
  }

  tech match {
    case Tech.Ice40 =>
      val mac = Mac16(signedA, signedB)
      mac.io.CE := io.enable
      mac.io.A  := io.a
      mac.io.B  := io.b
      Seq(mac.io.C, mac.io.D).foreach(_ := 0)
      Seq(
        mac.io.AHOLD, mac.io.BHOLD, mac.io.CHOLD, mac.io.DHOLD, mac.io.IRSTTOP, mac.io.IRSTBOT, mac.io.ORSTTOP,
        mac.io.ORSTBOT, mac.io.OLOADTOP, mac.io.OLOADBOT, mac.io.ADDSUBTOP, mac.io.ADDSUBBOT, mac.io.OHOLDTOP,
        mac.io.OHOLDBOT, mac.io.CI, mac.io.ACCUMCI, mac.io.SIGNEXTIN
      ).foreach(_ := False)
      io.product := mac.io.O
    case Tech.Generic =>
      def extended(v: Bits, signed: Boolean) = if (signed) v.asSInt.resize(17) else v.asUInt.resize(17).asSInt
      val a = RegNextWhen(io.a, io.enable)
      val b = RegNextWhen(io.b, io.enable)
      io.product := RegNextWhen((extended(a, signedA) * extended(b, signedB)).resize(32).asBits, io.enable)
  }
}

object Multiplier16 {
  val Latency = 2
}
