package frustum.synthesis

import spinal.core._

/** A unit between registers and with two data pins, so that place and route tells the clock of the unit and of nothing
  * else: its inputs come from a shift register, its outputs go to registers that are folded into another one.
  */
final class RegisteredUnit(make: => Component) extends Component {
  val io = new Bundle {
    val in = spinal.core.in Bool ()
    val out = spinal.core.out Bool ()
  }
  val unit = make
  unit.setDefinitionName("unit")
  private val clocks = unit.pulledDataCache.values.toSet[Data] // ports that a black box's clock made
  private val (inputs, outputs) = unit.getOrdredNodeIo.filterNot(clocks).partition(_.isInput)

  val shift = Reg(Bits(inputs.map(_.getBitsWidth).sum bits))
  shift := (shift ## io.in).resized
  inputs.foldLeft(0) { (at, signal) =>
    signal.assignFromBits(shift(at, signal.getBitsWidth bits))
    at + signal.getBitsWidth
  }

  val caught = RegNext(Cat(outputs.map(_.asBits)))
  val folded = Reg(Bits(widthOf(caught) bits))
  folded := caught ^ (folded |<< 1)
  io.out := folded.msb
}
