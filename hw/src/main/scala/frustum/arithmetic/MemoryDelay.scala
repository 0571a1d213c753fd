package frustum.arithmetic

import spinal.core._

/** The input of `clocks` cycles before, from a small memory in place of registers; until then 0. */
object MemoryDelay {
  def apply[T <: Data](that: T, clocks: Int): T = {
    require(clocks >= 2, s"MemoryDelay: $clocks cycles, at least 2")
    new Composite(that, "delayed") {
      private val bits = log2Up(clocks + 1)
      val memory = Mem(Bits(that.getBitsWidth bits), 1 << bits).initBigInt(Seq.fill(1 << bits)(BigInt(0)))
      val at = Reg(UInt(bits bits)) init 0
      at := at + 1
      memory.write(at, that.asBits)
      // A word is read, into the memory's register, before its place is written again.
      val late = cloneOf(that)
      late.assignFromBits(memory.readSync(at - (clocks - 1)))
    }.late
  }
}
