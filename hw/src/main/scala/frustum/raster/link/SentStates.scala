package frustum.raster.link

import frustum.contract.raster.RenderState
import spinal.core._
import spinal.lib._

/** The render state that a command names, and whether the frame has been sent it.
  *
  * A bit for each state goes round in a ring, a place a clock, until that of the state named is at its end: then
  * `found`, 17 clocks after `named` at the latest. This takes half the cells of a decoder and a multiplexer.
  */
case class SentStates() extends Component {
  private val count = RenderState.Count // a power of two
  val io = new Bundle {
    val fresh = in Bool () // no state of the frame has come yet
    val named = slave(Flow(Bits(16 bits))) // a command's first word; it stands for a clock before it is looked at
    val missing = out Bool () // there is no state of the number that stands there
    val index = out(Reg(UInt(log2Up(count) bits)))
    val found = out Bool ()
    val sent = out Bool () // where `found`
    val sends = in Bool () // the state named has been stored; where `found`
  }
  io.missing := RegNext(io.named.payload.dropLow(io.index.getWidth).orR)
  when(io.named.valid)(io.index := io.named.payload.asUInt.resized)

  val ring =
    Reg(Bits(count bits)) // its highest bit is that of state `place`, the next lower one that of the next state
  val place = Reg(UInt(log2Up(count) bits))
  io.found := place === io.index
  io.sent := ring.msb
  when(!io.found) {
    place := place + 1
    ring := ring.rotateLeft(1)
  }
  when(io.sends)(ring.msb := True)
  when(io.fresh)(ring.clearAll())
}
