package frustum.device

import spinal.core._

/** The clock of a design on an iCE40: a pad's clock multiplied by the PLL beside that pad.
  *
  * `clockOut` runs at `settings.outputMHz` once `locked`, about 50 us after power up or `enable`. With [[Tech.Generic]]
  * the clock passes straight through and is locked after its first cycles, so that a reset by the lock works as on the
  * device: a simulation drives the pad at the output frequency.
  */
case class Ice40Pll(settings: Ice40PllSettings, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val clockIn = in Bool ()
    val enable = in Bool ()
    val clockOut = out Bool ()
    val locked = out Bool ()
  }
  tech match {
    case Tech.Ice40 =>
      val cell = PllPad(settings)
      cell.io.PACKAGEPIN := io.clockIn
      cell.io.RESETB := io.enable
      cell.io.BYPASS := False
      io.clockOut := cell.io.PLLOUTGLOBAL
      io.locked := cell.io.LOCK
    case Tech.Artix7  => SpinalError("Ice40Pll: an Artix-7 has no such PLL; use Artix7ClockDivider")
    case Tech.Generic =>
      io.clockOut := io.clockIn
      val start = new ClockingArea(ClockDomain(io.clockIn, config = ClockDomainConfig(resetKind = BOOT))) {
        val clocks = Reg(UInt(3 bits)) init 0
        when(!clocks.andR)(clocks := clocks + 1)
      }
      io.locked := io.enable && start.clocks.andR
  }
}

/** SB_PLL40_PAD: the PLL fed by its own clock pad (Lattice, iCE40 Technology Library); RESETB is active low. */
case class PllPad(settings: Ice40PllSettings) extends BlackBox {
  setDefinitionName("SB_PLL40_PAD")
  addGeneric("FEEDBACK_PATH", "SIMPLE")
  addGeneric("PLLOUT_SELECT", "GENCLK")
  addGeneric("DIVR", B(settings.divr, 4 bits))
  addGeneric("DIVF", B(settings.divf, 7 bits))
  addGeneric("DIVQ", B(settings.divq, 3 bits))
  addGeneric("FILTER_RANGE", B(settings.filterRange, 3 bits))
  val io = new Bundle {
    val PACKAGEPIN = in Bool ()
    val RESETB = in Bool ()
    val BYPASS = in Bool ()
    val PLLOUTGLOBAL = out Bool ()
    val LOCK = out Bool ()
  }
  noIoPrefix()
}
