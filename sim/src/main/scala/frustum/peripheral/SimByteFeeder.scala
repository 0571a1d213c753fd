package frustum.peripheral

import spinal.core._
import spinal.core.sim._
import spinal.lib._

/** A source of bytes as simulated hardware: streams what the JVM has put into its ring, one byte a clock where the sink
  * takes it.
  *
  * @param bytesLog2 size of the ring
  */
case class SimByteFeeder(bytesLog2: Int = 17) extends Component {
  val io = new Bundle {
    val bytes = master(Stream(Bits(8 bits)))
    val stall = in Bool ()
    val queued = in UInt (32 bits) // bytes put into the ring since reset
    val sent = out(UInt(32 bits)).simPublic()
  }
  val memory = Mem(Bits(8 bits), 1 << bytesLog2).simPublic()
  val sent = RegInit(U(0, 32 bits))
  // Once offered, a byte stays offered.
  val held = RegNext(io.bytes.isStall, False)
  io.bytes.valid := sent =/= io.queued && (held || !io.stall)
  io.bytes.payload := memory.readAsync(sent.resized)
  when(io.bytes.fire)(sent := sent + 1)
  io.sent := sent
}
