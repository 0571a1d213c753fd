package frustum.boards

import frustum.boards.icebreaker.IcebreakerClock
import frustum.device.{SinglePortRam, Tech}
import spinal.core._
import spinal.lib._

/** A small design with everything the flow has to deal with: PLL, reset from a pin, a second clock, SPRAM, block RAM.
  */
case class BlinkTop(coreMHz: BigDecimal, tech: Tech) extends Component {
  val io = new Bundle {
    val clk, resetn, sck = in Bool ()
    val led = out Bool ()
  }
  noIoPrefix()

  val clocking = new IcebreakerClock(io.clk, io.resetn, coreMHz, tech)
  val serial = new ClockingArea(ClockDomain(io.sck, config = ClockDomainConfig(resetKind = BOOT))) {
    val toggle = RegInit(False)
    toggle := !toggle
  }
  val core = new ClockingArea(clocking.domain) {
    val counter = CounterFreeRun(1 << 16)
    val memory = SinglePortRam(words = 16384, width = 16, tech = tech)
    memory.io.enable := True
    memory.io.write := counter(0)
    memory.io.address := counter.value(15 downto 2)
    memory.io.writeData := counter.value.asBits
    memory.io.mask := 1
    val table = Mem(Bits(16 bits), 256) init Seq.tabulate(256)(i => B(i * i & 0xffff, 16 bits))
    val looked = table.readSync(memory.io.readData(7 downto 0).asUInt)
    io.led := RegNext(looked.xorR ^ BufferCC(serial.toggle, False))
  }
}

object BlinkTop {
  def table(coreMHz: BigDecimal, constraints: String): BoardTop = BoardTop(
    name = "blink",
    part = Part.Ice40Up5k,
    constraints = constraints,
    core = BoardClock(IcebreakerClock.Net, coreMHz, "PLL"),
    otherClocks = Seq(BoardClock("sck", 48, "host")),
    component = BlinkTop(coreMHz, _)
  )
}
