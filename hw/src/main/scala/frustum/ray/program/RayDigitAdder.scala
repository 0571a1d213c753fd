package frustum.ray.program

import spinal.core._

/** The use of a digit that [[RaySetup]] has read: it is the multiplier's, whose bit at `bitAt` is taken; the first
  * operand, which is kept, 0 with a multiplier's `top` bit; or the second, with which `sum` is the result's digit and
  * its carry. `start` comes before a step's first digit. A multiplication adds the second operand or nothing to the
  * first one doubled.
  */
class RayDigitAdder(multiplying: Bool, subtracting: Bool, digit: Bits, bitAt: UInt, top: Bool)(
    start: Bool,
    bit: Bool,
    first: Bool,
    second: Bool
) extends Area {
  private val bits = digit.getWidth
  val kept = Reg(UInt(bits bits))
  val shiftedIn = Reg(Bool()) // the carry of the doubled lower digit
  val carry = Reg(Bool())
  val multiplierBit = Reg(Bool())
  val subtract = Mux(multiplying, top, subtracting)
  val doubled = Mux(multiplying, (kept ## shiftedIn).asUInt.resize(bits), kept)
  val gate = !multiplying || multiplierBit
  val operand = (digit.asUInt & U(bits bits, default -> gate)) ^ U(bits bits, default -> subtract)
  val sum = (doubled +^ operand) + carry.asUInt

  when(start)(carry := subtracting)
  when(bit) {
    multiplierBit := digit(bitAt)
    carry := top
    shiftedIn := False
  }
  when(first) {
    kept := digit.asUInt
    when(multiplying && top)(kept := 0)
  }
  when(second) {
    carry := sum.msb
    shiftedIn := kept.msb
  }
}
