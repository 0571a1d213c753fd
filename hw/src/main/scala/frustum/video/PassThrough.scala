package frustum.video

import spinal.core._
import spinal.lib._

/** Lets the host drive the display itself: while `mux` is high its four signals go straight to the pins, without a
  * register between. Reset stays the core's, because the host has no such pin. A window that is being written when
  * `mux` changes is incomplete; the next one is right, because every window write starts with commands of its own.
  */
case class PassThrough() extends Component {
  val io = new Bundle {
    val mux = in Bool ()
    val sck, mosi, dc, cs = in Bool () // the host's signals
    val core = slave(DisplayPins())
    val pins = master(DisplayPins())
  }
  io.pins := io.core
  when(io.mux) {
    io.pins.sck := io.sck
    io.pins.mosi := io.mosi
    io.pins.dc := io.dc
    io.pins.cs := io.cs
  }
}
