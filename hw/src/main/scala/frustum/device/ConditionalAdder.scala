package frustum.device

import spinal.core._

/** `condition ? a + b : a`, no carry out: a row of a shift-and-add multiplier. On iCE40 one logic cell per bit, because
  * the cell's fourth input, which synthesis leaves unused beside a carry, chooses between sum and `a`.
  */
case class ConditionalAdder(width: Int, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val condition = in Bool ()
    val a, b = in UInt (width bits)
    val result = out UInt (width bits)
  }

  tech match {
    case _: Tech.Inferred => io.result := Mux(io.condition, io.a + io.b, io.a)
    case Tech.Ice40       =>
      io.result := LogicCell.chain(width, LogicCell.sumOrFirst, io.condition, io.a, io.b).asUInt
  }
}

/** SB_LUT4 of the iCE40; the output is bit {I3, I2, I1, I0} of `init`. */
case class LogicCell(init: Int) extends BlackBox {
  setDefinitionName("SB_LUT4")
  addGeneric("LUT_INIT", B(init, 16 bits))
  val io = new Bundle {
    val I0, I1, I2, I3 = in Bool ()
    val O = out Bool ()
  }
  noIoPrefix()
}

object LogicCell {

  /** A chain of adder cells, one per bit: `cell` has the control at I0, the operands at I1 and I2, the carry at I3. */
  def chain(width: Int, cell: => LogicCell, control: Bool, a: BitVector, b: BitVector): Bits = {
    var carry: Bool = False
    Cat(for (i <- 0 until width) yield {
      val logic = cell
      logic.io.I0 := control
      logic.io.I1 := a(i)
      logic.io.I2 := b(i)
      logic.io.I3 := carry
      if (i < width - 1) {
        val next = CarryCell()
        next.io.I0 := a(i)
        next.io.I1 := b(i)
        next.io.CI := carry
        carry = next.io.CO
      }
      logic.io.O
    })
  }

  /** I0 ? I1 ^ I2 ^ I3 : I1 */
  def sumOrFirst: LogicCell = LogicCell((0 until 16).map { i =>
    val sum = if ((i & 1) != 0) (i >> 1) ^ (i >> 2) ^ (i >> 3) else i >> 1
    (sum & 1) << i
  }.sum)
}

/** SB_CARRY of the iCE40: the majority of its inputs. */
case class CarryCell() extends BlackBox {
  setDefinitionName("SB_CARRY")
  val io = new Bundle {
    val I0, I1, CI = in Bool ()
    val CO = out Bool ()
  }
  noIoPrefix()
}
