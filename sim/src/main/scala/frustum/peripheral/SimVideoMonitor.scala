package frustum.peripheral

import frustum.contract.video.VideoMode
import spinal.core._
import spinal.core.sim._

/** What a monitor sees at its plug: colour, sync pulses of the mode's polarity, and which clocks are visible. */
case class MonitorPins(colorBits: Int) extends Bundle {
  val hSync, vSync, active = Bool()
  val color = Bits(colorBits bits)
}

/** A monitor as simulated hardware, so that the JVM has no work during a frame. It knows the mode's nominal
  * numbers, locks at the first vertical pulse that comes with or after a horizontal one, places pixels by counting
  * from the pulses, and from then on measures each width, porch and total to the clock; see [[SimVideoReader]].
  *
  * A frame ends where the next vertical pulse starts; frames lie in two memories in turn. The vertical pulse may
  * start at any clock from the start of a horizontal one to the line's first pixel, but always at the same.
  */
case class SimVideoMonitor(mode: VideoMode, colorBits: Int) extends Component {
  import SimVideoMonitor.{Few, Lanes}
  private val pixels = mode.width * mode.height
  require(pixels % Lanes == 0, s"${mode.width} x ${mode.height} pixels, not a multiple of $Lanes")
  val io = new Bundle {
    val pins = in(MonitorPins(colorBits))
    val frames = out(UInt(32 bits)).simPublic() // complete ones
    val errors = out(UInt(32 bits)).simPublic()
    val visible = out Bool () // by the pulses: for a plug that does not tell
  }
  private def edges(pulse: Bool) = {
    val before = RegNext(pulse) init True // a pulse that lasts since the reset tells nothing
    (pulse && !before, !pulse && before)
  }
  val (hStart, hEnd) = edges(if (mode.hPositive) io.pins.hSync else !io.pins.hSync)
  val (vStart, vEnd) = edges(if (mode.vPositive) io.pins.vSync else !io.pins.vSync)
  val (activeStart, activeEnd) = edges(io.pins.active)

  /** From the pulses to the first pixel, column and line, counted from the start of the horizontal pulse. */
  private val (left, top) = (mode.hSync + mode.hBack, mode.vSync + mode.vBack)
  val counting = RegInit(False) setWhen hStart
  private val locks = vStart && (counting || hStart)
  val locked = RegInit(False) setWhen locks
  val lock = locked || locks

  /** Clocks since the horizontal pulse, lines since the one that the vertical pulse is in. */
  val sinceH, sinceV = Reg(UInt(16 bits)) init 0
  val column = CombInit(sinceH)
  val row = CombInit(sinceV)
  when(hStart) {
    column := 0
    row := sinceV + 1
  }
  when(vStart)(row := 0)
  sinceH := column + 1
  sinceV := row
  val visible =
    locked && column >= left && column < left + mode.width && row >= top && row < top + mode.height
  io.visible := visible

  /** Where in its line the vertical pulse starts: the first one decides. */
  val phase = RegNextWhen(column, vStart && !locked).init(0).simPublic()
  val first = activeStart && row === top
  val lastEnd = activeEnd && row === top + mode.height - 1

  private def number(n: Int) = U(n, 32 bits)
  private val frame = mode.vTotal * mode.hTotal
  val hTotal = new SimInterval(hStart, hStart, lock, number(mode.hTotal))
  val hSync = new SimInterval(hStart, hEnd, lock, number(mode.hSync))
  val hBack = new SimInterval(
    hEnd,
    activeStart || hStart,
    lock && row >= top && row < top + mode.height,
    number(mode.hBack)
  )
  val width = new SimInterval(activeStart, activeEnd, lock, number(mode.width))
  val hFront = new SimInterval(activeEnd, hStart, lock, number(mode.hFront))
  val vTotal = new SimInterval(vStart, vStart, lock, number(frame))
  val vSync = new SimInterval(vStart, vEnd, lock, number(mode.vSync * mode.hTotal))
  val vBack = new SimInterval(vEnd, first, lock, number(mode.vBack * mode.hTotal + left) - phase)
  val vFront = new SimInterval(lastEnd, vStart, lock, number(mode.vFront * mode.hTotal + mode.hFront) + phase)

  private def count(wrong: Bool) = {
    val n = Reg(UInt(32 bits)).init(0).simPublic()
    when(wrong)(n := n + 1)
    n
  }
  val misplaced = count(locked && io.pins.active =/= visible)
  val blankColour = count(lock && !io.pins.active && io.pins.color.orR)
  val phaseWrong = count(vStart && lock && (column > left || locked && column =/= phase))

  /** What is measured, and what is only counted, by name. */
  val intervals = Seq(
    "hTotal" -> hTotal,
    "hSync" -> hSync,
    "hBack" -> hBack,
    "width" -> width,
    "hFront" -> hFront,
    "vTotal" -> vTotal,
    "vSync" -> vSync,
    "vBack" -> vBack,
    "vFront" -> vFront
  )
  val counts = Seq("misplaced" -> misplaced, "blankColour" -> blankColour, "phase" -> phaseWrong)
  io.errors := (intervals.map(_._2.wrong) ++ counts.map(_._2)).reduce(_ + _)

  val frames = count(vStart && locked)
  io.frames := frames
  val memory = Mem(Bits(Lanes * colorBits bits), 2 * pixels / Lanes).simPublic()
  val index = Reg(UInt(log2Up(pixels) bits)) init 0

  /** The last pixels of a word, and those before them: what is long moves only now and then. */
  val few = Reg(Bits((Few - 1) * colorBits bits)) init 0
  val collect = Reg(Bits((Lanes - Few) * colorBits bits)) init 0
  val word = io.pins.color ## few ## collect
  when(visible) {
    few := (io.pins.color ## few).dropLow(colorBits)
    index := index + 1
    when(index(log2Up(Few) - 1 downto 0).andR)(collect := word.dropLow(Few * colorBits))
  }
  when(vStart)(index := 0)
  private val wordIndex = (index >> log2Up(Lanes)).resize(memory.addressWidth)
  memory.write(
    Mux(frames(0), wordIndex + pixels / Lanes, wordIndex),
    word,
    visible && index(log2Up(Lanes) - 1 downto 0).andR
  )
}

object SimVideoMonitor {

  /** Pixels of a word of the memory. */
  val Lanes = 32

  /** Pixels that are put into it together. */
  private val Few = 4
}
