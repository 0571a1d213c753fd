package frustum.bus

import spinal.core._
import spinal.lib._

/** FIFO of 16-bit words whose writer can roll back: pushed words become visible to the reader at `commit` and are
  * discarded at `rollback`, which both concern the words pushed in earlier cycles only. Holds at least `depth - 2`
  * words.
  *
  * A push while `full` is lost; the writer has to check. `io.room` falls while fewer than `margin` words are free.
  * `full` is a cycle late, `room` two. Read latency two cycles after the commit, one word per cycle.
  *
  * @param depth a power of two; 256 words are one EBR of the iCE40
  */
case class CommitFifo(depth: Int = 256, margin: Int = 16) extends Component {
  require(isPow2(depth) && depth >= 8, s"CommitFifo: depth $depth is not a power of two from 8 up")
  require(margin < depth, s"CommitFifo: margin $margin is not below the depth $depth")
  val io = new Bundle {
    val push = slave(Flow(Bits(16 bits)))
    val commit = in Bool ()
    val rollback = in Bool ()
    val full = out Bool ()
    val room = out Bool ()
    val pop = master(Stream(Bits(16 bits)))
  }

  val memory = Mem(Bits(16 bits), depth)
  val written = Reg(UInt(log2Up(depth) bits)) init 0 // next word of the speculative part
  val committed = Reg(UInt(log2Up(depth) bits)) init 0 // end of the visible part
  val fetched = Reg(UInt(log2Up(depth) bits)) init 0 // next word to read

  val free = fetched - written - 1
  // One cycle late, so one more word may be pushed.
  io.full := RegNext(free <= 1) init False
  val late = RegNext(free) init 0
  io.room := RegNext(late >= margin) init False

  // A word is read a cycle after its commit at the earliest, hence never in the cycle in which it is written.
  val pushing = io.push.valid && !io.full
  memory.write(written, io.push.payload, pushing)
  when(pushing)(written := written + 1)
  when(io.commit)(committed := written)
  when(io.rollback)(written := committed)

  val valid = Reg(Bool()) init False
  val fetch = fetched =/= committed && (!valid || io.pop.ready)
  when(fetch)(fetched := fetched + 1)
  valid := fetch || (valid && !io.pop.ready)
  io.pop.valid := valid
  io.pop.payload := memory.readSync(fetched, fetch, readUnderWrite = dontCare)
}
