package frustum.arithmetic

import frustum.contract.arithmetic.ReciprocalTable
import spinal.core._

/** A line of [[frustum.contract.arithmetic.ReciprocalTable]], for a multiplier that adds: with x the 12 bits of f below
  * the line's index,
  * {{{r = 2 f / (1 + f) = (slope x + base 2^13) / 2^16     in units of 2^-16}}}
  */
case class ReciprocalLine() extends Bundle {
  val slope = Bits(ReciprocalTable.SlopeBits bits)
  val base = Bits(ReciprocalTable.BaseBits bits)

  def factor: Bits = slope.resize(16)
  def addend: Bits = base ## B(0, 32 - ReciprocalTable.BaseBits bits)
}

object ReciprocalLine {

  /** Cycles from an index to its line. */
  val Latency = 1

  /** f: the line's index and x. */
  private val FBits = ReciprocalTable.IndexBits + ReciprocalTable.FractionBits

  /** x of f, 20 bits, as an operand of a multiplier. */
  def fraction(f: UInt): Bits = f(ReciprocalTable.FractionBits - 1 downto 0).asBits.resize(16)

  /** r, 16 bits, from the product of `factor` and `fraction` with `addend` added. */
  def reciprocal(product: Bits): Bits = product(31 downto 16)

  /** The line of f, from one memory of 256 x 32. */
  def read(f: UInt, enable: Bool = True): ReciprocalLine = {
    require(f.getWidth == FBits, s"ReciprocalLine: f of ${f.getWidth} bits, not $FBits")
    val lines = Mem(Bits(32 bits), ReciprocalTable.lines.map(B(_, 32 bits)))
    lines.addAttribute("ram_style", "block") // otherwise tools make five levels of logic of a memory of this size
    lines.readSync(f(FBits - 1 downto ReciprocalTable.FractionBits), enable).as(ReciprocalLine())
  }
}
