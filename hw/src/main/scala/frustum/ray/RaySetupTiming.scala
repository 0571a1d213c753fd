package frustum.ray

import frustum.spec.{RayProgram, RayStep}

/** How long a set-up takes whose words have digits of `digitBits`, a power of two: the fewer digits, the faster and the larger. */
case class RaySetupTiming(program: RayProgram, digitBits: Int) {
  import program._
  val digits: Int = (wordWidth + digitBits - 1) / digitBits

  /** Bits of a multiplication's second operand; those beyond the words' width do not matter. */
  def multiplierBits(s: RayStep): Int = scala.math.min(s.bits, digits * digitBits)

  private def clocks(s: RayStep): Int =
    if (s.op == RayStep.Multiply) 2 + multiplierBits(s) * (1 + 2 * digits) else 2 + 2 * digits

  /** After `latch`: until the inputs are taken, until all is done. */
  val takeClocks: Int  = 1 + inputs.size.max(1) * digits
  val frameClocks: Int = takeClocks + frame.map(clocks).sum + 2

  /** After `line`: until the walkers are loaded, and from then on until the state has moved on. */
  val lineClocks: Int = loadWords + 4
  val rowClocks: Int  = row.map(clocks).sum + 2
}

object RaySetupTiming {

  /** Widths of digits, each a number of block memories of 16 bits. */
  val Digits: Seq[Int] = Seq(16, 32, 64)
}
