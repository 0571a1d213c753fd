package frustum.ray.walk

import frustum.contract.ray.{RayForm, RayProgram}
import frustum.ray.program.RayRowLoad
import spinal.core._

/** Value of one form at the current pixel by forward differences: at `step` it moves one pixel to the right.
  *
  * `load` fills the registers between rows, by the adders of the walk: `clear` sets them to their start value if that
  * is a constant, to 0 otherwise, and the loaded words are added up to the value. So no register needs a multiplexer in
  * addition to its adder, and a constant difference needs no register; it shares the adder's operand with the words.
  *
  * @param fast whether words are taken a cycle after they come
  */
case class FormWalker(form: RayForm, program: RayProgram, fast: Boolean = false) extends Component {
  import form.{loaded, registers, start}
  val io = new Bundle {
    val load = in(RayRowLoad(program))
    val step = in Bool ()
    val value = out SInt (form.width bits)
  }
  private def late[T <: Data](that: T): T = if (fast) RegNext(that) else that

  private def at(i: Int) = late(io.load.valid && io.load.index === form.first + i)
  private val loading = late(io.load.valid)
  private val clear = late(io.load.clear)
  private val word = late(io.load.data.asSInt.resize(form.width))
  private def constant(i: Int) = wrapped(start(i).getOrElse(BigInt(0)))
  private def wrapped(v: BigInt) = {
    val modulo = v & ((BigInt(1) << form.width) - 1)
    S(if (modulo.testBit(form.width - 1)) modulo - (BigInt(1) << form.width) else modulo, form.width bits)
  }
  private def wordOr(difference: Int) = Mux(loading, word, constant(difference))

  /** A register that adds `by` when `moves`, and what it is after `clear` (and `again`). */
  private def sum(moves: Bool, by: SInt, first: SInt, again: Bool = False): SInt = {
    val r = Reg(SInt(form.width bits))
    when(moves)(r := r + by)
    when(clear || again)(r := first)
    r
  }
  private val zero = S(0, form.width bits)
  private def kept(moves: Bool): SInt = RegNextWhen(word, moves)

  io.value := ((registers, loaded) match {
    case (1, 0) => constant(0)
    case (1, _) => kept(at(0))
    case (2, 0) => sum(io.step, constant(1), constant(0))
    case (2, 1) => sum(io.step || at(0), wordOr(1), zero)
    case (2, _) =>
      val step = kept(at(0) || at(1))
      sum(io.step || at(1), step, zero)
    case (_, 0) =>
      val step = sum(io.step, constant(2), constant(1))
      sum(io.step, step, constant(0))
    case (_, 2) =>
      val step = sum(io.step || at(0) || at(2), wordOr(2), zero, again = at(1))
      sum(io.step || at(1), step, zero)
    case _ =>
      val curve = kept(at(0) || at(1) || at(3))
      val step = sum(io.step || at(1) || at(3), curve, zero, again = at(2))
      sum(io.step || at(2), step, zero)
  })
}
