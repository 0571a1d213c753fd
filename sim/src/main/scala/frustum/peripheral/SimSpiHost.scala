package frustum.peripheral

import frustum.bus.CommandPins
import spinal.core._
import spinal.core.sim._
import spinal.lib._

/** An SPI host as simulated hardware: shifts out what the JVM has put into its memory, a byte after the other, SCK at
  * half the clock or slower, and pauses while `cts` is low at a byte's start. Chip select stays low while it works.
  *
  * @param bytesLog2  size of its memory
  * @param halfPeriod of SCK in clocks
  */
case class SimSpiHost(bytesLog2: Int = 18, halfPeriod: Int = 1) extends Component {
  val io = new Bundle {
    val pins = master(CommandPins())
    val cts = in Bool ()
    val bytes = in UInt (bytesLog2 + 1 bits) // how many to send in all; may grow
    val sent = out UInt (bytesLog2 + 1 bits)
  }
  val memory = Mem(Bits(8 bits), 1 << bytesLog2).simPublic()

  val sent = RegInit(U(0, bytesLog2 + 1 bits))
  val active = RegInit(False)
  val sck = RegInit(False)
  val bit = RegInit(U(0, 3 bits))
  val shift = Reg(Bits(8 bits))
  val timer = RegInit(U(0, log2Up(halfPeriod + 1) bits))
  val tick = timer === halfPeriod - 1
  val last = active && tick && sck && bit === 7
  val start = (!active || last) && sent =/= io.bytes && io.cts

  timer := Mux(tick || !active, U(0), timer + 1)
  when(active && tick) {
    sck := !sck
    when(sck) {
      shift := shift |<< 1
      bit := bit + 1
    }
  }
  when(last)(active := False)
  when(start) {
    active := True
    shift := memory.readAsync(sent.resized)
    sent := sent + 1
  }
  io.pins.sck := sck
  io.pins.mosi := shift.msb
  io.pins.cs := RegNext(!active && sent === io.bytes) init False // its first edge resets the slave
  io.sent := sent
}

object SimSpiHost {

  /** Puts bytes into the memory from `at` on; what was sent may be overwritten. */
  def load(memory: Mem[Bits], bytes: Seq[Int], at: Int = 0): Unit = {
    require(
      at + bytes.length <= memory.wordCount,
      s"SimSpiHost: ${at + bytes.length} bytes, room for ${memory.wordCount}"
    )
    for ((b, i) <- bytes.zipWithIndex) memory.setBigInt(at + i, BigInt(b))
  }
}
