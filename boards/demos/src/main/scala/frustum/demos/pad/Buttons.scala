package frustum.demos.pad

import spinal.core._
import spinal.lib._

/** Contacts that bounce, in another clock domain or in none: two flip-flops, then a look at each `sample`; what two
  * looks in a row agree on is what holds. With looks a frame apart (17 ms) a bounce is over between them.
  */
case class Buttons(count: Int) extends Component {
  val io = new Bundle {
    val pins = in Bits (count bits) // high = pressed, asynchronous
    val sample = in Bool ()
    val held = out Bits (count bits) // changes in the cycle after `sample`
  }
  val pins = BufferCC(io.pins, init = B(0, count bits))
  val before = RegNextWhen(pins, io.sample) init 0
  val held = Reg(Bits(count bits)) init 0
  when(io.sample)(held := (held & (pins | before)) | (pins & before))
  io.held := held
}
