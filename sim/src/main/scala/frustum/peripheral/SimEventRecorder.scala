package frustum.peripheral

import spinal.core._
import spinal.core.sim._

/** Keeps when its inputs pulsed in a ring, for the JVM to fetch in bulk. No two may pulse in one clock.
  *
  * @param kinds       inputs, at most 8
  * @param entriesLog2 size of the ring
  */
case class SimEventRecorder(kinds: Int, entriesLog2: Int = 15) extends Component {
  val io = new Bundle {
    val pulses = in Vec (Bool(), kinds)
    val time = in UInt (36 bits)
    val count = out(UInt(32 bits)).simPublic() // events since reset
  }
  val memory = Mem(Bits(64 bits), 1 << entriesLog2).simPublic()
  val count = RegInit(U(0, 32 bits))
  val any = io.pulses.asBits.orR
  val kind = io.pulses.zipWithIndex.map { case (pulse, i) => Mux(pulse, U(i, 3 bits), U(0, 3 bits)) }.reduce(_ | _)
  memory.write(count.resize(entriesLog2), (io.time ## kind).resize(64), any)
  when(any)(count := count + 1)
  io.count := count
}

object SimEventRecorder {

  /** Kind and time of event `index`, counted from reset; it must still be in the ring. */
  def entry(dut: SimEventRecorder, index: Long): (Int, Long) = {
    val word = dut.memory.getBigInt(index & ((1L << dut.entriesLog2) - 1)).toLong
    ((word & 7).toInt, word >>> 3)
  }
}
