package frustum.harness

import frustum.raster.store.StoreBus
import spinal.core._
import spinal.core.formal._
import spinal.lib._

/** Surroundings of a unit of which something is claimed: whatever keeps the rules may come in. */
object Claims {

  /** Offers anything at any time, steadily until it is taken. */
  def source[T <: Data](up: Stream[T]): Unit = {
    anyseq(up.valid)
    anyseq(up.payload)
    up.formalAssumesSlave()
  }

  /** Takes at any time, and claims that what is offered stays, unchanged, until then. */
  def sink[T <: Data](down: Stream[T]): Unit = {
    anyseq(down.ready)
    down.formalAssertsMaster()
  }

  /** A store that holds anything and answers a clock after it took a request.
    *
    * @param steady
    *   claims that requests stay until they are taken
    */
  def store(bus: StoreBus, steady: Boolean = true): Unit = {
    if (steady) sink(bus.cmd) else anyseq(bus.cmd.ready)
    bus.rsp.valid := RegNext(bus.cmd.fire && !bus.cmd.write) init False
    anyseq(bus.rsp.payload)
  }
}
