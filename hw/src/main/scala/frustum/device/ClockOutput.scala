package frustum.device

import spinal.core._

/** The clock at a pin, inverted, so that its rising edge is in the middle of the data of registers: by the pad's double
  * data rate registers on an iCE40; elsewhere plain logic.
  *
  * @param gated only the periods at whose start `enable`, a register's, rises or stays high
  */
case class ClockOutput(tech: Tech = Tech.Generic, gated: Boolean = false) extends Component {
  val io = new Bundle {
    val enable = gated generate in(Bool())
    val pin = out Bool ()
  }
  private val on = if (gated) io.enable else True
  val now = ClockDomain.current.readClockWire
  tech match {
    case Tech.Ice40 =>
      val cell = Ice40DoubleRateOutput()
      cell.io.OUTPUTCLK := now
      cell.io.DOUT0 := False
      cell.io.DOUT1 := on
      io.pin := cell.io.PACKAGEPIN
    case _: Tech.Inferred => io.pin := (if (gated) !now && on else !now)
  }
}

/** SB_IO as output at both edges: `DOUT0` after the rising one (Lattice, iCE40 Technology Library). */
case class Ice40DoubleRateOutput() extends BlackBox {
  setDefinitionName("SB_IO")
  addGeneric("PIN_TYPE", B"010001")
  val io = new Bundle {
    val PACKAGEPIN = out Bool ()
    val OUTPUTCLK = in Bool ()
    val DOUT0, DOUT1 = in Bool ()
  }
  io.PACKAGEPIN.setName("PACKAGE_PIN")
  io.OUTPUTCLK.setName("OUTPUT_CLK")
  io.DOUT0.setName("D_OUT_0")
  io.DOUT1.setName("D_OUT_1")
}
