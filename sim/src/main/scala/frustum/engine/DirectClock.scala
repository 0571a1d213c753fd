package frustum.engine

import scala.collection.mutable
import spinal.core._
import spinal.core.sim._
import spinal.sim.{Signal, SimManagerContext}

/** Clocks a simulated system by calls of its simulator, past SpinalSim's queue of events, which takes longer over a
  * clock than a small system does. For a system that is left alone meanwhile: no other thread of the simulation runs,
  * simulated time stands still, no waveform is written. To be made first thing in the simulation, in place of
  * `forkStimulus`.
  */
final class DirectClock(domain: ClockDomain) {
  private val manager = SimManagerContext.current.manager
  private val simulator = manager.raw

  /** The top's port that the domain's clock comes in by. */
  private val clock = {
    val port = manager.userData.asInstanceOf[Component].pulledDataCache.getOrElse(domain.clock, domain.clock)
    simulator.userData.asInstanceOf[mutable.ArrayBuffer[Signal]](port.asInstanceOf[Bool].algoInt)
  }

  if (domain.hasResetSignal) domain.assertReset() // from power up on, as on a board
  domain.fallingEdge()
  if (domain.hasResetSignal) {
    run(DirectClock.Reset)
    domain.deassertReset()
  }

  /** Lets so many rising edges pass; what was assigned before holds from the first. */
  def run(clocks: Long): Unit = {
    // Only the thread that the simulator was made in may call it.
    delayed(1)(edges(clocks))
    sleep(2)
  }

  private def edges(clocks: Long): Unit = {
    var left = clocks
    while (left > 0) {
      simulator.setLong(clock, 1)
      simulator.eval()
      simulator.setLong(clock, 0)
      simulator.eval()
      left -= 1
    }
  }
}

object DirectClock {

  /** Clocks under reset at the start. */
  val Reset = 16
}
