package frustum.bus

import spinal.core._
import spinal.lib._

/** The host's side of the command port. `cs` is active low. */
case class CommandPins() extends Bundle with IMasterSlave {
  val sck, mosi, cs, miso = Bool()
  override def asMaster(): Unit = { out(sck, mosi, cs); in(miso) }
}

/** SPI slave, mode 0, most significant bit first, clocked by SCK itself: SCK may be faster than the core clock, as long
  * as eight of its periods last at least five periods of the core clock, and may stop after any bit: nothing depends on
  * a further edge. A high `cs` resets the bit count, so a frame that ends within a byte loses that byte alone.
  *
  * A byte waits in a register of the SCK domain while a toggle crosses to the core; it leaves `bytes` three to four
  * core clocks after its last bit and must be taken before the next.
  *
  * MISO answers every frame of chip select with `firstByte`, `secondByte` and then bytes of the core. The byte is
  * requested by its index while the one before it is being sent, so its value is at most two bytes old. In a longer
  * frame bytes 2 to 9 repeat.
  *
  * @param firstByte  byte 0 of an answer
  * @param secondByte byte 1, a constant because nothing can be prepared while byte 0 is sent
  */
case class SpiSlave(firstByte: Int, secondByte: Int) extends Component {
  val io = new Bundle {
    val pins = slave(CommandPins())
    val bytes = master(Stream(Bits(8 bits)))
    val ask = out UInt (3 bits) // index, modulo 8, of the byte of the answer that is prepared next
    val answer = in Bits (8 bits) // the requested byte
  }

  // The timing of the pins is that of SCK, whatever drives them.
  io.pins.mosi.addTag(crossClockDomain)

  // The core's side, declared first because the SCK domain reads it.
  val statusByte = Reg(Bits(8 bits))

  val rising = new ClockingArea(SpiSlave.domain(io.pins, RISING)) {
    val shift = Reg(Bits(7 bits))
    val bit = Reg(UInt(3 bits)) init 0
    val index = Reg(UInt(3 bits)) init 0 // bytes of this frame, modulo 8
    val ended = Reg(Bool()) init False // this edge ends a byte
    val fresh = Reg(Bool()) init True // no byte of this frame has ended
    val first = Reg(Bool()) init False // the last byte that ended was the frame's first
    shift := shift(5 downto 0) ## io.pins.mosi
    bit := bit + 1
    ended := bit === 7
    when(bit === 7) {
      index := index + 1
      fresh := False
      first := fresh
    }
  }
  // Not touched by `cs`: a byte stays valid after the frame ends.
  val held = new ClockingArea(ClockDomain(io.pins.sck, config = ClockDomainConfig(resetKind = BOOT))) {
    val byte = Reg(Bits(8 bits))
    val toggle = Reg(Bool()) init False
    when(rising.bit === 7) {
      byte := rising.shift ## io.pins.mosi
      toggle := !toggle
    }
  }
  val falling = new ClockingArea(SpiSlave.domain(io.pins, FALLING)) {
    val shift = Reg(Bits(8 bits)) init firstByte
    val next = Mux(rising.first, B(secondByte, 8 bits), statusByte.addTag(crossClockDomain))
    // Nothing is prepared while the first byte comes, so the second byte of the answer is a constant.
    shift := Mux(rising.ended, next, shift |<< 1)
  }
  io.pins.miso := falling.shift.msb

  // Without reset: after a reset of the core alone, the toggle must not be taken for a byte.
  val toggle = BufferCC(held.toggle, bufferDepth = Some(2))
  val arrived = toggle =/= RegNext(toggle)
  val byte = RegNextWhen(held.byte.addTag(crossClockDomain), arrived)
  val valid = RegInit(False) setWhen arrived clearWhen (io.bytes.ready && !arrived)
  io.bytes.valid := valid
  io.bytes.payload := byte

  // When byte n has arrived, byte n + 1 of the answer is on the wire, n + 2 is prepared, and `index` is n + 1.
  io.ask := rising.index.addTag(crossClockDomain) + 1
  when(arrived)(statusByte := io.answer)
}

object SpiSlave {
  private def domain(pins: CommandPins, edge: EdgeKind) = ClockDomain(
    clock = pins.sck,
    reset = pins.cs,
    config = ClockDomainConfig(clockEdge = edge, resetKind = ASYNC, resetActiveLevel = HIGH)
  )
}
