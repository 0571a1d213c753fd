package frustum.demos.pad

import spinal.core._
import spinal.lib._
import spinal.lib.com.spi.{SpiMasterCtrl, SpiMasterCtrlGenerics}

/** A console pad's wires; `dat` needs a pull-up. */
case class ConsolePadPins() extends Bundle with IMasterSlave {
  val att = Bool() // low while the pad is asked
  val sck = Bool()
  val cmd = Bool() // to the pad
  val dat = Bool() // from it
  override def asMaster(): Unit = { out(att, sck, cmd); in(dat) }
}

/** Asks a console's pad, digital (id 0x41) or with sticks (0x73), what is held: SPI mode 3, least significant bit
  * first, bytes 01 42 00 ..., of which the pad answers the second with its id, the third with 5A, then two of buttons
  * and, with sticks, four of those.
  *
  * An answer counts when it is whole: without a pad, with another id or when the pad goes away meanwhile, the state is
  * at rest. A pad that goes away leaves ones; four sticks at 255 at once are taken for that. A question takes some 1.1
  * ms with sticks at 83 kHz: nine bytes, and [[ConsolePad.PauseMicros]] before each.
  *
  * @param clockHz core clock
  * @param sckHz   at most; pads take some 250 kHz
  */
case class ConsolePad(clockHz: Long, sckHz: Int = 83333) extends Component {
  require(clockHz >= 4L * sckHz, s"ConsolePad: a clock of $clockHz Hz is less than 4 times SCK's $sckHz")
  val io = new Bundle {
    val poll = in Bool () // asks, unless an answer is under way; once a frame is enough
    val pins = master(ConsolePadPins())
    val state = out(PadState())
    val done = out Bool () // pulses when `state` is new
  }
  private val toggle =
    ((clockHz + 2L * sckHz - 1) / (2L * sckHz) - 2).toInt // SpiMasterCtrl takes two cycles more
  private val pause = (clockHz * ConsolePad.PauseMicros / 1000000).toInt.max(8)

  val spi =
    SpiMasterCtrl(SpiMasterCtrlGenerics(ssWidth = 0, timerWidth = log2Up(toggle + 1).max(1), dataWidth = 8))
  spi.io.config.kind.cpol := True
  spi.io.config.kind.cpha := True
  spi.io.config.sclkToggle := toggle

  // The answer to byte n is answer(n); that to the first means nothing.
  val answer = Vec.fill(ConsolePad.Bytes)(Reg(Bits(8 bits)))
  val busy = RegInit(False)
  val index = Reg(UInt(4 bits)) // byte to send
  val arrived = Reg(UInt(4 bits)) // bytes answered
  val waiting = Reg(UInt(log2Up(pause + 1) bits)) // before the next byte
  val id = answer(1)
  val sticks = id === ConsolePad.Analogue
  val last = Mux(sticks, U(ConsolePad.Bytes, 4 bits), U(ConsolePad.DigitalBytes, 4 bits))
  val ended = busy && waiting === 0 && index === last && index > 1

  spi.io.cmd.valid := busy && waiting === 0 && !ended
  spi.io.cmd.args.assignFromBits(B"1" ## index.mux(
    0 -> B(0x01, 8 bits),
    1 -> B(0x42, 8 bits),
    default -> B(0, 8 bits)
  ).reversed)
  io.pins.att := !busy
  io.pins.sck := spi.io.spi.sclk
  io.pins.cmd := spi.io.spi.mosi
  spi.io.spi.miso := BufferCC(io.pins.dat, init = True)

  when(waiting =/= 0)(waiting := waiting - 1)
  when(io.poll && !busy) {
    busy := True
    index := 0
    arrived := 0
    waiting := pause
  }
  when(spi.io.cmd.fire) {
    index := index + 1
    waiting := pause
  }
  when(spi.io.rsp.valid) {
    answer(arrived.resized) := spi.io.rsp.payload.reversed
    arrived := arrived + 1
  }

  val gone = sticks && answer.drop(5).map(_.andR).andR
  val whole = (sticks || id === ConsolePad.Digital) && answer(2) === ConsolePad.Ready && !gone
  val state = Reg(PadState())
  state.connected init False
  state.buttons.foreach(_ init False)
  state.sticks.foreach(_ init 128)
  when(ended) {
    busy := False
    state.rest()
    when(whole) {
      state.connected := True
      for ((button, i) <- state.buttons.zipWithIndex) button := !answer(3 + i / 8)(i % 8)
      when(sticks) { for ((stick, i) <- state.sticks.zipWithIndex) stick := answer(5 + i).asUInt }
    }
  }
  io.state := state
  io.done := RegNext(ended) init False
}

object ConsolePad {
  val Digital = 0x41
  val Analogue = 0x73
  val Ready = 0x5a

  val DigitalBytes = 5
  val Bytes = 9

  /** Pause before each byte, which the pad's processor needs. */
  val PauseMicros = 20
}
