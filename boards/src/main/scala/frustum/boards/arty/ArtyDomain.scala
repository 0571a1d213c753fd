package frustum.boards.arty

import spinal.core._
import spinal.lib.ResetCtrl

/** A clock domain of the Arty: the red button resets it at once and lets go in time with its clock. */
object ArtyDomain {
  def apply(clock: Bool, resetn: Bool, frequency: HertzNumber): ClockDomain = {
    val unreset = ClockDomain(clock, config = ClockDomainConfig(resetKind = BOOT))
    ClockDomain(
      clock = clock,
      reset =
        ResetCtrl.asyncAssertSyncDeassert(!resetn, unreset, inputPolarity = HIGH, outputPolarity = HIGH),
      frequency = ClockDomain.FixedFrequency(frequency)
    )
  }
}
