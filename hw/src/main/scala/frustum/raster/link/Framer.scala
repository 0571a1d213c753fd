package frustum.raster.link

import frustum.bus.CommitFifo
import frustum.contract.raster.{Command, CommandShape}
import spinal.core._
import spinal.lib._

/** Bytes of the wire into checked commands; the format is in [[frustum.contract.raster.Command]].
  *
  * A command comes out as one word `opcode << 8 | length` and its payload, only if its checksum is right, its opcode
  * known and its length one that the opcode allows. Everything else is dropped, with one pulse of `dropped` for each: a
  * command with an error, one cut short by the next flag, one that found no room, and a run of bytes before any flag (a
  * command whose flag was lost). Flags may repeat as padding.
  *
  * Takes a byte per cycle except for three cycles after a length and one after a checksum.
  *
  * @param dropWhenFull false: the byte stream waits while the FIFO is full; true: bytes are always taken and a command
  *                     that finds it full is dropped, for sources that cannot wait
  */
case class Framer(depth: Int = 256, dropWhenFull: Boolean = false) extends Component {
  require(depth >= 256, s"Framer: depth $depth cannot hold a command of ${Command.MaxWords} words and the margin")
  val io = new Bundle {
    val bytes = slave(Stream(Bits(8 bits)))
    val words = master(Stream(Bits(16 bits)))
    val dropped = out Bool ()
    val room = out Bool () // low: at most Framer.BytesAfterRoom more bytes are sure to be kept
  }
  import FramerState._

  val fifo = CommitFifo(depth, margin = Framer.MarginWords)
  io.words << fifo.io.pop
  io.room := fifo.io.room

  val state = RegInit(stray)
  val escaped = RegInit(False)
  val second = Reg(Bool()) // the current byte is the second of its word
  val high = Reg(Bits(8 bits))
  val low = Reg(Bits(8 bits)) // the byte before
  val left = Reg(UInt(7 bits)) // remaining payload words
  val crc = Reg(Bits(16 bits))

  // Flags and unescaped bytes, a cycle later.
  val isFlag = io.bytes.payload === Command.Flag
  val isEscape = io.bytes.payload === Command.Escape && !escaped
  val plain = io.bytes.payload ^ (escaped.asBits.resize(8) |<< log2Up(Command.EscapeXor))
  when(io.bytes.fire)(escaped := isEscape)
  val symbols = io.bytes.throwWhen(isEscape).translateWith(isFlag ## plain).m2sPipe()
  // Opcode and length are stable for two cycles before they are checked.
  val fits = RegNext(Command.all.map(c => RegNext(high === c.opcode) && RegNext(Framer.lengthAccepted(c, low))).orR)
  val inWord = state === stray || state === skip || state === header || state === body
  symbols.ready := inWord && (if (dropWhenFull) True else fifo.io.room)

  val flag = symbols.fire && symbols.payload.msb
  val data = symbols.fire && !symbols.payload.msb
  val byte = symbols.payload(7 downto 0)

  // Words reach the FIFO a cycle later: two cycles at least before a commit, and before the next word is complete.
  val push = False
  val drop = False
  when(data)(low := byte)
  fifo.io.push.valid := RegNext(push) init False
  fifo.io.push.payload := high ## low
  fifo.io.commit := False
  io.dropped := RegNext(drop) init False
  fifo.io.rollback := io.dropped // no word is pushed before the second byte from here

  when(data) {
    crc := Framer.crcNext(crc, byte)
    second := !second
    when(!second)(high := byte)
  }
  switch(state) {
    is(stray) {
      when(data) { drop := True; state := skip }
    }
    is(header)(when(data && second)(state := look))
    is(look)(state := lookOn)
    is(lookOn)(state := judge)
    is(judge) {
      left := low.asUInt.resized
      when(fits) { push := True; state := body } otherwise { drop := True; state := skip }
    }
    is(body) {
      when(data && second) {
        left := left - 1
        when(left === 0)(state := check) otherwise (push := True)
      }
    }
    is(check) {
      when(crc === 0) { fifo.io.commit := True; state := stray } otherwise { drop := True; state := skip }
    }
  }
  when(fifo.io.push.valid && fifo.io.full) { drop := True; state := skip }
  when(flag) {
    drop := state === body || (state === header && second)
    state := header
    second := False
    crc := B"xFFFF"
  }
}

/** `stray`: no command begun, the next byte that is no flag is an error; `skip`: error counted, waiting for a flag. */
object FramerState extends SpinalEnum {
  val stray, skip, header, look, lookOn, judge, body, check = newElement()
}

object Framer {

  /** Words free when `room` falls; some of their bytes may still be in flight in the slave. */
  val MarginWords = 16

  /** Bytes that may follow the fall of `room` (`cts`) without loss. */
  val BytesAfterRoom = 24

  /** One byte of CRC-16/CCITT-FALSE. With t = byte ^ crc.high and u = t ^ t >> 4, the polynomial x^16 + x^12 + x^5 + 1
    * gives crc.low << 8 ^ u << 12 ^ u << 5 ^ u.
    */
  def crcNext(crc: Bits, byte: Bits): Bits = {
    val t = crc(15 downto 8) ^ byte
    val u = (t ^ (t |>> 4)).resize(16)
    (crc |<< 8) ^ (u |<< 12) ^ (u |<< 5) ^ u
  }

  /** The command may have this length. Progressions by a power of two take a comparison, others a list. */
  def lengthAccepted(command: Command, length: Bits): Bool = {
    val lengths = CommandShape.lengths(command)
    val step = if (lengths.size > 1) lengths(1) - lengths.head else 0
    if (lengths.size > 2 && isPow2(step)) {
      val aligned = if (step == 1) True else length(log2Up(step) - 1 downto 0) === lengths.head % step
      aligned && length.asUInt >= lengths.head && length.asUInt <= Command.MaxWords
    } else lengths.map(length === _).orR
  }
}
