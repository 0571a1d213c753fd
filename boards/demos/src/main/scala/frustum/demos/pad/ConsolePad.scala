package frustum.demos.pad

import spinal.core._
import spinal.lib._
import spinal.lib.com.spi.{SpiMasterCtrl, SpiMasterCtrlGenerics}

/** A console pad's wires; `dat` needs a pull-up. */
case class ConsolePadPins() extends Bundle with IMasterSlave {
  val att = Bool() // low during an exchange
  val sck = Bool()
  val cmd = Bool() // to the pad
  val dat = Bool() // from it
  override def asMaster(): Unit = { out(att, sck, cmd); in(dat) }
}

/** Reads a console's pad: SPI mode 3, least significant bit first, bytes 01 42 00 ..., of which the pad answers the
  * second with its id, the third with 5A, then as many pairs of bytes as the id's low digit says (nocash, PSX
  * specifications). The first pair is buttons, the next two are sticks where the id is one of [[ConsolePad.Sticks]];
  * all pairs are fetched, and the others ignored.
  *
  * An answer counts when it is complete: without a pad, with an id that is none of [[ConsolePad.Ids]] or when the pad
  * is removed meanwhile, the state is at rest. Without a pad the line reads as ones; four bytes of 255 after the
  * buttons count as a removed pad. An exchange takes about 1.1 ms with sticks at 83 kHz, nine bytes and
  * [[ConsolePad.PauseMicros]] before each, and 2.5 ms with pressures, 21 bytes.
  *
  * @param clockHz core clock
  * @param sckHz   at most; pads support about 250 kHz
  */
case class ConsolePad(clockHz: Long, sckHz: Int = 83333) extends Component {
  require(clockHz >= 4L * sckHz, s"ConsolePad: a clock of $clockHz Hz is less than 4 times SCK's $sckHz")
  val io = new Bundle {
    val poll = in Bool () // starts an exchange unless one is in progress; once per frame is enough
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

  // The answer to byte n is answer(n); that to the first is undefined.
  val answer = Vec.fill(ConsolePad.Bytes)(Reg(Bits(8 bits)))
  val busy = RegInit(False)
  val index = Reg(UInt(5 bits)) // byte to send
  val arrived = Reg(UInt(5 bits)) // bytes answered
  val waiting = Reg(UInt(log2Up(pause + 1) bits)) // cycles until the next byte
  val id = answer(1)
  val known = ConsolePad.Ids.map(id === _).orR
  val sticks = ConsolePad.Sticks.map(id === _).orR
  val pairs = Mux(known, id(3 downto 0).asUInt, U(1, 4 bits))
  val last = (pairs @@ False).resize(5) + ConsolePad.HeaderBytes
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
    when(arrived < ConsolePad.Bytes)(answer(arrived.resized) := spi.io.rsp.payload.reversed)
    arrived := arrived + 1
  }

  val gone = pairs =/= 1 && answer.drop(5).map(_.andR).andR
  val whole = known && answer(2) === ConsolePad.Ready && !gone
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

  /** Two sticks, and how hard each button is pressed. */
  val Pressure = 0x79

  /** A pair of joysticks, whose axes come in the order of sticks. */
  val Joystick = 0x53

  /** Buttons and a wheel, which is ignored. */
  val Wheel = 0xe3

  val Sticks = Seq(Analogue, Pressure, Joystick)
  val Ids = Sticks ++ Seq(Digital, Wheel)
  val Ready = 0x5a

  /** Before the pairs. */
  val HeaderBytes = 3

  /** Of an answer, up to its sticks. */
  val Bytes = 9

  /** Pause before each byte, which the pad's processor needs. */
  val PauseMicros = 20
}
