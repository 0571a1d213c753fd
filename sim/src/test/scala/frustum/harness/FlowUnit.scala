package frustum.harness

import spinal.core._
import spinal.lib._

/** Puts a unit that cannot wait between two Streams: what enters has room waiting at the other end. */
object FlowUnit {

  /** @param underWay
    *   at least as many outputs as may still come when nothing enters any more
    */
  def apply[A <: Data, B <: Data](
      up: Stream[A],
      down: Stream[B],
      underWay: Int
  )(unit: Stream[A] => Flow[B]): Unit = {
    val fifo = StreamFifo(down.payloadType(), 4 * underWay)
    val out = unit(up.haltWhen(fifo.io.availability <= underWay))
    fifo.io.push.valid := out.valid
    fifo.io.push.payload := out.payload
    down << fifo.io.pop
  }
}
