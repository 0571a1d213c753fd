package frustum.boards.arty

import spinal.core._
import spinal.lib.{History, ResetCtrl}

/** A clock domain of the Arty: reset at power up and by the red button. The reset is a register of the clock, and
  * synchronous.
  */
object ArtyDomain {

  /** Clocks of reset from power up on. */
  private val PowerUp = 4

  def apply(clock: Bool, resetn: Bool, frequency: HertzNumber): ClockDomain = {
    val unreset = ClockDomain(clock, config = ClockDomainConfig(resetKind = BOOT))
    val button = ResetCtrl.asyncAssertSyncDeassert(!resetn, unreset, inputPolarity = HIGH, outputPolarity = HIGH)
    val reset = unreset(RegNext(button || !History(True, PowerUp, init = False).last) init True)
    ClockDomain(
      clock,
      reset,
      config = ClockDomainConfig(resetKind = SYNC),
      frequency = ClockDomain.FixedFrequency(frequency)
    )
  }
}
