package frustum.boards.icebreaker

import frustum.device.{Ice40Pll, Ice40PllSettings, Tech}
import spinal.core._
import spinal.lib.ResetCtrl

/** Clock and reset of a design on the iCEBreaker: its 12 MHz oscillator through the PLL.
  *
  * Reset asserts at once and is released in step with the clock, when the PLL has locked and `run` is high. The lock
  * also outlasts the first microseconds after configuration, in which block RAM does not read.
  *
  * @param clockPin the oscillator's pad (FPGA pin 35)
  * @param run      from a pin, not synchronised; low resets
  */
class IcebreakerClock(clockPin: Bool, run: Bool, coreMHz: BigDecimal, tech: Tech) extends Area {
  val pll = Ice40Pll(Ice40PllSettings(BigDecimal(12), coreMHz), tech)
  pll.io.clockIn := clockPin
  pll.io.enable := True

  private val unreset = ClockDomain(pll.io.clockOut, config = ClockDomainConfig(resetKind = BOOT))
  val reset = ResetCtrl.asyncAssertSyncDeassert(
    input = !(pll.io.locked && run),
    clockDomain = unreset,
    inputPolarity = HIGH,
    outputPolarity = HIGH
  )
  val domain = ClockDomain(
    clock = pll.io.clockOut,
    reset = reset,
    frequency = ClockDomain.FixedFrequency(coreMHz.toDouble MHz)
  )
}

object IcebreakerClock {

  /** The core clock's name in the netlist of a top that names this area `clocking`. */
  val Net = "clocking_pll_io_clockOut"
}
