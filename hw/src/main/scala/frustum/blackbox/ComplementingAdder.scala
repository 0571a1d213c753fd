package frustum.blackbox

import spinal.core._

/** `complement ? ~(a + b) : a + b`. On iCE40 one logic cell a bit, because the cell's fourth input, which synthesis leaves
  * unused beside a carry, complements the sum.
  */
case class ComplementingAdder(width: Int, tech: Tech) extends Component {
  val io = new Bundle {
    val complement = in Bool ()
    val a, b       = in SInt (width bits)
    val result     = out SInt (width bits)
  }

  tech match {
    case Tech.Generic => io.result := (io.a + io.b) ^ S(width bits, default -> io.complement)
    case Tech.Ice40   =>
      var carry: Bool = False
      val bits = for (i <- 0 until width) yield {
        val cell = LogicCell(ComplementingAdder.Parity)
        cell.io.I0 := io.complement
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
      io.result := Cat(bits).asSInt
  }
}

object ComplementingAdder {
  /** Truth table of the exclusive or of four inputs. */
  private val Parity = (0 until 16).map(i => (java.lang.Integer.bitCount(i) & 1) << i).sum
}
