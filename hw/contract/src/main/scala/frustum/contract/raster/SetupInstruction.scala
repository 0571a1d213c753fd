package frustum.contract.raster

/** One instruction of the set-up engine: a multiply-accumulate of two scratch words, and the use of the sum.
  *
  * With words of 32 signed bits, `accumulator = start +- floor(a * b / 2^16)`, 48 bits, wrapping. An instruction takes
  * two cycles; a result can be read by the fourth instruction after it ([[SetupInstruction.ResultLatency]]).
  *
  * Where `a` is `Left`, `Right` is read in its place if that makes the product larger, with `far`, or smaller, without;
  * where `a` is `Top`, with `far`, `Bottom` if that makes it larger.
  *
  * `b` must stay below 2^31 - 2^15: the engine multiplies by b's upper half rounded and its lower half signed.
  */
final case class SetupInstruction(
    a: SetupWord,
    b: SetupWord,
    start: SetupInstruction.Start,
    subtract: Boolean,
    result: SetupInstruction.Result,
    far: Boolean = false
)

object SetupInstruction {
  val ResultLatency = 4

  /** What the accumulator holds before the product is added. */
  sealed abstract class Start(val code: Int)
  case object Keep extends Start(0)
  case object Zero extends Start(1)

  /** Half of the last place of a [[Fraction]] result. */
  case object Round extends Start(2)

  /** [[Round]], or [[Zero]] where the triangle is a sliver. */
  case object RoundGradient extends Start(3)

  /** The destination of the accumulator. Integers are bits 31..0, fractions (of 30 places) bits 45..14, gradients
    * fractions or, where the triangle is a sliver, integers.
    */
  sealed abstract class Result(val code: Int) {

    /** The word that is written. */
    def word: Option[SetupWord] = this match {
      case Integer(w)  => Some(w)
      case Fraction(w) => Some(w)
      case Checked(w)  => Some(w)
      case _           => None
    }
  }
  case object Nowhere extends Result(0)
  final case class Integer(to: SetupWord) extends Result(1)
  final case class Fraction(to: SetupWord) extends Result(2)

  /** An integer that must fit 30 bits, otherwise the triangle is a sliver. */
  final case class Checked(to: SetupWord) extends Result(3)
  final case class GradientX(plane: Int) extends Result(4)
  final case class GradientY(plane: Int) extends Result(5)

  /** Fraction: the plane's value at the first pixel. */
  final case class Initial(plane: Int) extends Result(6)

  /** Integer: edge function `edge` at the walker's corner; its steps are `b` of the products with `Left` and `Top`. Or,
    * for `edge` 4 and up, edge function `edge - 4` at the corner of the tile where it is largest.
    */
  final case class Edge(edge: Int) extends Result(7)

  /** Bits of an instruction word: far 1, a is `Top` 1, a is `Left` 1, result code 3, target 7, start 2, subtract 1, b
    * 7, a 7. Words are named by [[SetupMemory.code]].
    */
  val WordBits = 30
  def encode(i: SetupInstruction, memory: SetupMemory): Int = {
    import memory.code
    val target = i.result match {
      case GradientX(p) => p
      case GradientY(p) => p
      case Initial(p)   => p
      case Edge(e)      => e
      case other        => other.word.fold(0)(code)
    }
    def bit(b: Boolean, at: Int) = (if (b) 1 else 0) << at
    bit(i.far, 29) | bit(i.a == SetupWords.Top, 28) | bit(
      i.a == SetupWords.Left,
      27
    ) | i.result.code << 24 | target << 17 |
      i.start.code << 15 | bit(i.subtract, 14) | code(i.b) << 7 | code(i.a)
  }
}
