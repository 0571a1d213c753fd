package frustum.device

import spinal.core._

/** A clock of a quarter of the frequency, on a global clock net. With [[Tech.Generic]] the clock passes straight
  * through: a simulation drives it at the output's frequency.
  */
case class Artix7ClockDivider(tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val clockIn = in Bool ()
    val clockOut = out Bool ()
  }
  tech match {
    case Tech.Artix7 =>
      val fast = new ClockingArea(ClockDomain(io.clockIn, config = ClockDomainConfig(resetKind = BOOT))) {
        val count = Reg(UInt(2 bits)) init 0
        count := count + 1
      }
      val buffer = Artix7GlobalBuffer()
      buffer.io.I := fast.count.msb
      io.clockOut := buffer.io.O
    case Tech.Generic => io.clockOut := io.clockIn
    case Tech.Ice40   => SpinalError("Artix7ClockDivider: an iCE40 has no BUFG; use Ice40Pll")
  }
}

/** BUFG: drives a global clock net (Xilinx UG472). */
case class Artix7GlobalBuffer() extends BlackBox {
  setDefinitionName("BUFG")
  val io = new Bundle {
    val I = in Bool ()
    val O = out Bool ()
  }
  noIoPrefix()
}
