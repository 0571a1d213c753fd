package frustum.video

import frustum.device.{ClockOutput, Tech}
import spinal.core._
import spinal.lib._

/** A byte for the display, `data` low for a command. */
case class DisplayByte() extends Bundle {
  val data = Bool()
  val value = Bits(8 bits)
}

/** Serialises bytes, SPI mode 0 or 3, most significant bit first, `clocksPerBit` cycles per bit. Between bytes that
  * come in time, one per `8 * clocksPerBit` cycles, there is no idle cycle. `cs` rises when none follows.
  * (SpiMasterCtrl of spinal.lib needs idle cycles between bytes.)
  *
  * With one cycle per bit SCK is the clock itself, see [[frustum.device.ClockOutput]].
  *
  * @param restHigh SCK is high while no byte is sent: mode 3. Within a byte both modes are alike
  */
case class ByteShifter(clocksPerBit: Int, tech: Tech = Tech.Generic, restHigh: Boolean = false) extends Component {
  require(clocksPerBit >= 1 && isPow2(clocksPerBit), s"ByteShifter: $clocksPerBit cycles per bit, not 1, 2, 4, 8 ...")
  require(!restHigh || clocksPerBit >= 2, "ByteShifter: SPI mode 3 needs at least 2 cycles per bit")
  val io = new Bundle {
    val bytes = slave(Stream(DisplayByte()))
    val sck, mosi, dc, cs = out Bool ()
  }
  val phaseBits = log2Up(clocksPerBit)
  val count = RegInit(U(0, 3 + phaseBits bits))
  val active = RegInit(False)
  val shift = Reg(Bits(8 bits))
  val data = Reg(Bool())

  io.bytes.ready := !active || count.andR
  when(active) {
    count := count + 1
    when(if (phaseBits == 0) True else count(phaseBits - 1 downto 0).andR)(shift := shift |<< 1)
  }
  when(io.bytes.ready)(active := io.bytes.valid)
  when(io.bytes.fire) {
    shift := io.bytes.value
    data := io.bytes.data
  }
  io.sck := (
    if (restHigh) {
      // A register of its own: from count and `active` together there would be a pulse where both change.
      val goesOn = Mux(io.bytes.ready, io.bytes.valid, active)
      val next = Mux(active, count + 1, count)
      RegNext(!goesOn || next(phaseBits - 1)) init True
    } else if (phaseBits > 0) count(phaseBits - 1)
    else {
      val clock = ClockOutput(tech, gated = true)
      clock.io.enable := active
      clock.io.pin
    }
  )
  io.mosi := shift.msb
  io.dc := data
  io.cs := !active
}
