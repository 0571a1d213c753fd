package frustum.ray

import frustum.spec.{RayForm, RayProgram}
import spinal.core._
import spinal.lib._

/** Value of one form at the current pixel by forward differences: at `step` it moves one pixel to the right.
  *
  * `load` fills the registers between rows. Only the last one takes words; to the others they go by the adders that are
  * there already: value and step are cleared, and what comes is added up to its place. So no register needs a
  * multiplexer beside its adder.
  */
case class FormWalker(form: RayForm, program: RayProgram) extends Component {
  val io = new Bundle {
    val load  = slave(Flow(RayRegisterLoad(program)))
    val step  = in Bool ()
    val value = out SInt (form.width bits)
  }
  private def at(slot: Int) = io.load.valid && io.load.index === form.register + slot
  private def register      = Reg(SInt(form.width bits))
  private val word          = io.load.data.asSInt.resize(form.width)
  val value                 = register
  io.value := value

  val linear = form.registers == 2 generate new Area {
    val step = register
    when(io.step || at(1))(value := value + step)
    when(at(0))(value            := 0)
    when(at(0) || at(1))(step    := word)
  }
  val quadratic = form.registers == 3 generate new Area {
    val step          = register
    val curve         = register
    when(io.step || at(2))(value         := value + step)
    when(io.step || at(1) || at(3))(step := step + curve)
    when(at(0))(value                    := 0)
    when(at(0) || at(2))(step            := 0)
    when(at(0) || at(1) || at(3))(curve  := word)
  }
  if (form.registers == 1) when(at(0))(value := word)
}
