package frustum.peripheral

import frustum.video.DisplayPins
import spinal.core._
import spinal.core.sim._
import spinal.lib._

/** The display's serial port as simulated hardware, so that a frame takes no work of the JVM while it is sent: samples
  * the pins at every clock, collects bytes and keeps them in a ring, to be fetched in bulk by [[SimTftReader]].
  *
  * An entry has 16 bits: byte, D/C at its last bit, whether the reset pin was low since the entry before, and the
  * time since the entry before in units of `2^gapLog2` clocks, at most 63. Bits of a byte cut short by chip select
  * are forgotten.
  *
  * @param entriesLog2 size of the ring; a frame of 240 x 320 has 154,000 bytes
  * @param selectPin without one the port is selected from the end of reset on, and SCK must not rest low
  */
case class SimTft(entriesLog2: Int = 18, gapLog2: Int = 10, selectPin: Boolean = true) extends Component {
  val io = new Bundle {
    val pins = slave(DisplayPins())
    val count = out(UInt(32 bits)).simPublic() // entries so far
    val low = out(Bool()).simPublic() // SCK has rested low where it must not
  }
  val lanes = SimTft.Lanes
  val memory = Mem(Bits(16 * lanes bits), (1 << entriesLog2) / lanes).simPublic()

  val selected = io.pins.reset && (if (selectPin) !io.pins.cs else True)
  val rising = io.pins.sck && RegNext(!io.pins.sck) && selected
  val bit = RegInit(U(0, 3 bits))
  val shift = Reg(Bits(8 bits))
  val next = shift(6 downto 0) ## io.pins.mosi
  when(rising) {
    shift := next
    bit := bit + 1
  }
  when(!selected)(bit := 0)
  val complete = rising && bit === 7

  val count = RegInit(U(0, 32 bits))
  val wasReset = RegInit(True) clearWhen complete setWhen !io.pins.reset
  val clocks = RegInit(U(0, 6 + gapLog2 bits))
  when(!clocks.andR)(clocks := clocks + 1)
  when(complete || !io.pins.reset)(clocks := 0) // after a reset the gap counts from its end
  when(complete)(count := count + 1)

  val entry = clocks(gapLog2, 6 bits) ## wasReset ## io.pins.dc ## next
  val line = Reg(Bits(16 * lanes bits)) init 0
  val lane = count(log2Up(lanes) - 1 downto 0)
  when(complete)(line(lane << 4, 16 bits) := entry)
  // The unfinished line is written along, a clock after each entry.
  memory.write((RegNext(count) >> log2Up(lanes)).resize(memory.addressWidth), line, RegNext(complete) init False)
  io.count := RegNext(count) init 0

  val rest = RegInit(U(0, log2Up(SimTft.RestClocks) bits))
  rest := (io.pins.sck || bit =/= 0 || !selected) ? U(0) | (rest + (!rest.andR).asUInt)
  io.low := RegInit(False) setWhen (Bool(!selectPin) && rest.andR)
}

object SimTft {
  val Lanes = 32

  /** A level that lasts so many clocks between bytes is one of rest: a bit takes far fewer. */
  val RestClocks = 64
}

/** Takes what a [[SimTft]] has collected to a controller model.
  *
  * @param clockHz of the simulated core
  * @param fast    by how much the display's pauses are shortened: the model's time runs that much faster
  */
final class SimTftReader(dut: SimTft, controller: TftController, clockHz: Long, fast: Int) {
  private var taken = 0L
  private var timeMs = 0.0
  private var toldLow = false
  private val unitMs = 1000.0 * fast * (1 << dut.gapLog2) / clockHz

  /** Bytes taken so far. */
  def bytes: Long = taken

  /** Call before the ring has run over: at least once per `2^entriesLog2` bytes. */
  def drain(): Unit = {
    val count = dut.io.count.toLong
    if (dut.io.low.toBoolean && !toldLow) { toldLow = true; controller.restedLow() }
    require(count - taken <= (1L << dut.entriesLog2), s"SimTft: ${count - taken} bytes were not fetched in time")
    while (taken < count) {
      val line = dut.memory.getBigInt((taken / SimTft.Lanes) % dut.memory.wordCount)
      val until = count.min((taken / SimTft.Lanes + 1) * SimTft.Lanes)
      while (taken < until) {
        take(((line >> (16 * (taken % SimTft.Lanes).toInt)) & 0xffff).toInt)
        taken += 1
      }
    }
  }

  private def take(entry: Int): Unit = {
    if ((entry & 0x200) != 0) controller.reset(timeMs, lowMs = Double.PositiveInfinity)
    timeMs += (entry >> 10) * unitMs
    controller.byte((entry & 0x100) != 0, entry & 255, timeMs)
  }
}
