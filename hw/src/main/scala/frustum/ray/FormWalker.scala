package frustum.ray

import frustum.spec.{RayForm, RayProgram}
import spinal.core._
import spinal.lib._

/** Value of one form at the current pixel by forward differences: at `step` it moves one pixel to the right.
  * Registers are filled by `load` between rows.
  */
case class FormWalker(form: RayForm, program: RayProgram) extends Component {
  val io = new Bundle {
    val load  = slave(Flow(RayRegisterLoad(program)))
    val step  = in Bool ()
    val value = out SInt (form.width bits)
  }
  private def register(i: Int) = {
    val need = program.words(program.load + form.register + i).range.width
    Reg(SInt(scala.math.min(form.width, if (i == 0) form.width else need) bits))
  }
  val registers = List.tabulate(form.registers)(register)
  when(io.step) {
    for ((r, by) <- registers.zip(registers.drop(1))) r := r + by.resized
  }
  for ((r, i) <- registers.zipWithIndex)
    when(io.load.valid && io.load.index === form.register + i) { r := io.load.data.asSInt.resized }
  io.value := registers.head
}
