package frustum.boards.arty

import spinal.core._
import spinal.lib.{History, ResetCtrl}

/** A clock domain of the Arty: reset from power up for [[ArtyDomain.PowerUpClocks]] clocks, and at once by the red button, which lets
  * go in time with the clock.
  */
object ArtyDomain {
  val PowerUpClocks = 4

  def apply(clock: Bool, resetn: Bool, frequency: HertzNumber): ClockDomain = {
    val unreset = ClockDomain(clock, config = ClockDomainConfig(resetKind = BOOT))
    val powered = unreset(History(True, 1 to PowerUpClocks, init = False).last)
    val button  = ResetCtrl.asyncAssertSyncDeassert(!resetn, unreset, inputPolarity = HIGH, outputPolarity = HIGH)
    // A register each, of which one alone changes at a time: the gate has no spikes.
    ClockDomain(clock = clock, reset = button || !powered, frequency = ClockDomain.FixedFrequency(frequency))
  }
}
