package frustum.ray.program

import frustum.contract.ray.{RayProgram, RayStep}

/** How long a set-up takes whose words have digits of `digitBits`, a power of two: the fewer digits, the faster and the
  * larger.
  *
  * @param fast whether it has registers for a higher clock frequency, and walkers too; then words have two digits or
  *   more
  */
case class RaySetupTiming(program: RayProgram, digitBits: Int, fast: Boolean = false) {
  import program._
  val digits: Int = ((wordWidth + digitBits - 1) / digitBits).max(if (fast) 2 else 1)
  private val waits = if (fast) RaySetupTiming.Waits else 0

  /** Bits of a multiplication's second operand; those beyond the words' width do not matter. */
  def multiplierBits(s: RayStep): Int = scala.math.min(s.bits, digits * digitBits)

  private def clocks(s: RayStep): Int =
    2 + waits + (if (s.op == RayStep.Multiply) multiplierBits(s) * (1 + 2 * digits) else 2 * digits)

  /** After `latch`: until the inputs are taken, until all is done. */
  val takeClocks: Int = 1 + inputs.size.max(1) * digits
  val frameClocks: Int = takeClocks + frame.map(clocks).sum + 2 + waits

  /** After `line`: until the walkers are loaded, and from then on until the state is advanced. */
  val lineClocks: Int = loadWords + 4 + waits
  val rowClocks: Int = row.map(clocks).sum + 2 + waits
}

object RaySetupTiming {

  /** Widths of digits, each a number of block memories of 16 bits. */
  val Digits: Seq[Int] = Seq(16, 32, 64)

  /** Clocks that a step of a fast set-up waits, in which the step before it writes and its instruction comes. */
  val Waits = 2
}
