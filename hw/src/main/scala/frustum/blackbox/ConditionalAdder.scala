package frustum.blackbox

import spinal.core._

/** `condition ? a + b : a`, no carry out: a row of a shift-and-add multiplier. On iCE40 one logic cell a bit,
  * because the cell's fourth input, which synthesis leaves unused beside a carry, chooses between sum and
  * `a`.
  */
case class ConditionalAdder(width: Int, tech: Tech) extends Component {
  val io = new Bundle {
    val condition = in Bool ()
    val a, b = in UInt (width bits)
    val result = out UInt (width bits)
  }

  tech match {
    case Tech.Generic => io.result := Mux(io.condition, io.a + io.b, io.a)
    case Tech.Ice40   =>
      var carry: Bool = False
      val bits = for (i <- 0 until width) yield {
        val cell = LogicCell.sumOrFirst
        cell.io.I0 := io.condition
        cell.io.I1 := io.a(i)
        cell.io.I2 := io.b(i)
        cell.io.I3 := carry
        if (i < width - 1) {
          val next = CarryCell()
          next.io.I0 := io.a(i)
          next.io.I1 := io.b(i)
          next.io.CI := carry
          carry = next.io.CO
        }
        cell.io.O
      }
      io.result := Cat(bits).asUInt
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
