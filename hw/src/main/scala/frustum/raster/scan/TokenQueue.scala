package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** The token being drawn and the one after it. What they need must not be overwritten meanwhile: their slots, and, of a
  * slot, the entries for first values, of which there are two. `slotUsed` and `full` are a cycle late.
  */
case class TokenQueue(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(DrawToken(config)))
    val down = master(Stream(DrawToken(config)))
    val slot = in UInt (log2Up(config.slots) bits)
    val slotUsed = out Bool () // a token of `slot` is held
    val full = out Bool () // two triangles' tokens are held
    val busy = out Bool ()
  }
  val waiting = io.up.halfPipe() // cuts the path of ready
  val drawn = waiting.m2sPipe()
  private def holds(token: Stream[DrawToken]) = token.valid && !token.tileEnd
  io.down << drawn
  io.slotUsed := RegNext(Seq(waiting, drawn).map(token => holds(token) && token.slot === io.slot).orR)
  io.full := RegNext(holds(waiting) && holds(drawn))
  io.busy := waiting.valid || drawn.valid
}
