package frustum.arithmetic

import frustum.device.{Mac16, Tech}
import spinal.core._

/** 16 x 16 -> 32 bit product, exact, latency two cycles of `enable`: operands are registered, then the product. While
  * `enable` is low both stages hold, so it stalls with a pipeline. On iCE40 it is one SB_MAC16.
  *
  * @param signedA,signedB
  *   whether that operand is two's complement; the product is, if either operand is
  * @param add
  *   the product is a * b + addend modulo 2^32 instead, the addend given with the operands
  * @param subtract
  *   with `add`: the product is addend - a * b
  * @param hold
  *   while `holdA` is high, the operand a registered last is used again
  */
case class Multiplier16(
    tech: Tech = Tech.Generic,
    signedA: Boolean,
    signedB: Boolean,
    add: Boolean = false,
    subtract: Boolean = false,
    hold: Boolean = false
) extends Component {
  require(add || !subtract, s"Multiplier16: subtract $subtract without add")
  val io = new Bundle {
    val enable = in Bool ()
    val a, b = in Bits (16 bits)
    val addend = add generate in(Bits(32 bits))
    val holdA = hold generate in(Bool())
    val product = out Bits (32 bits)
  }
  private val holdA = if (hold) io.holdA else False

  tech match {
    case Tech.Ice40 =>
      val mac = Mac16(signedA, signedB, add)
      mac.io.CE := io.enable
      mac.io.A := io.a
      mac.io.B := io.b
      mac.io.C := (if (add) io.addend(31 downto 16) else B(0, 16 bits))
      mac.io.D := (if (add) io.addend(15 downto 0) else B(0, 16 bits))
      mac.idle(besides = mac.io.AHOLD, mac.io.ADDSUBTOP, mac.io.ADDSUBBOT)
      mac.io.AHOLD := holdA
      mac.io.ADDSUBTOP := Bool(subtract)
      mac.io.ADDSUBBOT := Bool(subtract)
      io.product := mac.io.O
    case _: Tech.Inferred =>
      def extended(v: Bits, signed: Boolean) = if (signed) v.asSInt.resize(17) else v.asUInt.resize(17).asSInt
      val a = RegNextWhen(io.a, io.enable && !holdA)
      val b = RegNextWhen(io.b, io.enable)
      val product = (extended(a, signedA) * extended(b, signedB)).resize(32)
      def addend = RegNextWhen(io.addend, io.enable).asSInt
      val sum = if (subtract) addend - product else if (add) product + addend else product
      io.product := RegNextWhen(sum.asBits, io.enable)
  }
}

object Multiplier16 {
  val Latency = 2
}
