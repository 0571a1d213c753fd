package frustum.demos.pad

import spinal.core._
import spinal.lib._

/** Contacts that bounce, in another clock domain or in none: two flip-flops, then a sample at each `sample`; a state
  * holds when two samples in a row are equal. With samples a frame apart (17 ms) a bounce ends between them.
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
