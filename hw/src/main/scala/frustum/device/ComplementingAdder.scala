package frustum.device

import spinal.core._

/** `complement ? ~(a + b) : a + b`. On iCE40 one logic cell per bit, because the cell's fourth input, which synthesis
  * leaves unused beside a carry, complements the sum.
  */
case class ComplementingAdder(width: Int, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val complement = in Bool ()
    val a, b = in SInt (width bits)
    val result = out SInt (width bits)
  }

  tech match {
    case _: Tech.Inferred => io.result := (io.a + io.b) ^ S(width bits, default -> io.complement)
    case Tech.Ice40       =>
      io.result := LogicCell.chain(width, LogicCell(ComplementingAdder.Parity), io.complement, io.a, io.b).asSInt
  }
}

object ComplementingAdder {

  /** Truth table of the exclusive or of four inputs. */
  private val Parity = (0 until 16).map(i => (java.lang.Integer.bitCount(i) & 1) << i).sum
}
