package frustum.video

import spinal.core._
import spinal.lib._

/** Pins of a four-wire serial display: `dc` high for data, `cs` and `reset` active low. */
case class DisplayPins() extends Bundle with IMasterSlave {
  val sck, mosi, dc, cs, reset = Bool()
  override def asMaster(): Unit = out(sck, mosi, dc, cs, reset)
}
