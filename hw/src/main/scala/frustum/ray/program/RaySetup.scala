package frustum.ray.program

import frustum.contract.ray.RayStep
import spinal.core._
import spinal.lib._
import spinal.lib.fsm._

/** Runs a [[frustum.contract.ray.RayProgram]] on one memory, whose words are read in one cycle and written a digit at a
  * time, and one adder of a digit. A multiplication takes its second operand's bits from the top, doubles what it has
  * and adds the first operand or not.
  *
  * `latch` takes the inputs, which must stay for `takeClocks`, and makes the frame's coefficients, `frameClocks` long.
  * `line` gives the words of the row to come, one per cycle, in `lineClocks`, then advances the state to the next row
  * in `rowClocks`, see [[RaySetupTiming]]. A `line` or `latch` while busy cuts off what runs.
  *
  * Where the timing is `fast`, instruction, digit that is read and sum are registered: the adder works a cycle behind
  * the states, the memory is written two behind, and a step waits until the one before has written.
  */
case class RaySetup(timing: RaySetupTiming) extends Component {
  import timing._
  import timing.program._
  val io = new Bundle {
    val latch, line = in Bool ()
    val inputs = in(Vec(program.inputs.map(i => SInt(i.range.width bits))))
    val load = out(RayRowLoad(program))
    val busy = out Bool ()
  }
  private val width = digits * digitBits
  private val addressBits = log2Up(size)
  private val bitBits = log2Up(width)
  private val digitLog = log2Up(digitBits)
  private val steps = frame ++ row
  private def late[T <: Data](that: T): T = if (fast) RegNext(that) else that
  require(!row.exists(_.op == RayStep.Multiply), "a row's steps are additions")

  private def digit(v: BigInt, d: Int) = v >> (d * digitBits) & ((BigInt(1) << digitBits) - 1)
  val columns = Seq.tabulate(digits) { d =>
    Mem(
      Bits(digitBits bits),
      size
    ).initBigInt((0 until size).map(a => digit(constants.getOrElse(a, BigInt(0)), d)))
  }
  private def encoded(s: RayStep): BigInt =
    Seq(
      s.op -> 2,
      (multiplierBits(s) - 1) -> bitBits,
      s.to -> addressBits,
      s.a -> addressBits,
      s.b -> addressBits
    )
      .foldLeft(BigInt(0)) { case (word, (v, bits)) => word << bits | v }
  val steprom = Mem(Bits(2 + bitBits + 3 * addressBits bits), steps.size).initBigInt(steps.map(encoded))
  val pc, end = Reg(UInt(log2Up(steps.size + 1) bits))
  val instruction = late(steprom.readSync(pc.resize(log2Up(steps.size))))
  private def address(place: Int) = instruction(place * addressBits, addressBits bits).asUInt
  private val (b, a, to) = (address(0), address(1), address(2))
  private val topBit = instruction(3 * addressBits, bitBits bits).asUInt
  private val op = instruction(3 * addressBits + bitBits, 2 bits).asUInt
  private val multiplying = late(op === RayStep.Multiply)
  private val subtracting = late(op === RayStep.Subtract)

  val count = Reg(UInt(log2Up(loadWords.max(inputs.size).max(2)) bits))
  val place = Reg(UInt(bitBits - digitLog bits)) // the digit's place in its word
  val bitPlace = Reg(UInt(bitBits bits))
  private val lastPlace = if (digits == 1) True else place === digits - 1
  private def digitOf(word: Bits): Bits = {
    val all = Vec.tabulate(digits)(d => word(d * digitBits, digitBits bits))
    if (digits == 1) all.head else all.read(place.resize(log2Up(digits)))
  }
  val readAddress = CombInit(a)
  val read = columns.map(_.readSync(readAddress)).reverse.reduce(_ ## _)

  /** The use of the state's word, and when its digit has arrived. */
  val now = new Area {
    val start, bit, first, second, take = False
    val top = Reg(Bool()) // the multiplier's highest bit, which counts negative
  }
  val due = new Area {
    val start = late(now.start)
    val bit = late(now.bit)
    val first = late(now.first)
    val second = late(now.second)
    val take = late(now.take)
    val top = late(now.top)
    val at = late(place)
    val bitAt = late(bitPlace.resize(digitLog))
    val digit = late(digitOf(read))
    private val n = count.resize(log2Up(inputs.size.max(2)))
    private def ofInputs(f: => Bits) = if (inputs.isEmpty) B(0, 0 bits) else late(f)
    val taken = ofInputs(digitOf(Vec(io.inputs.map(_.resize(width).asBits)).read(n)))
    val takenTo = ofInputs(Vec(inputs.map(i => B(i.address, addressBits bits))).read(n))
  }

  val adder = new RayDigitAdder(multiplying, subtracting, due.digit, due.bitAt, due.top)(
    due.start,
    due.bit,
    due.first,
    due.second
  )
  val writeAddress = CombInit(to)
  val writeData = CombInit(adder.sum.resize(digitBits).asBits)
  if (inputs.nonEmpty) when(due.take) {
    writeAddress := due.takenTo.asUInt
    writeData := due.taken
  }
  // Before their first cycle under reset registers are undefined: the constants must keep their values.
  private val writes = late(due.second || due.take && Bool(inputs.nonEmpty)) && !ClockDomain.current.isResetActive
  private val (toWord, toDigit, written) = (late(writeAddress), late(due.at), late(writeData))
  for ((column, d) <- columns.zipWithIndex)
    column.write(toWord, written, if (digits == 1) writes else writes && toDigit === d)

  val loading = RegNext(False) init False
  io.load.clear := late(RegNext(io.line) init False)
  io.load.valid := late(loading)
  io.load.index := late(RegNext(count.resize(io.load.index.getWidth)))
  io.load.data := late(read).resized

  val fsm = new StateMachine {
    val idle = makeInstantEntry()
    val take, fetch, start, bit, first, second, load = new State
    take.whenIsActive {
      now.take := True
      place := place + 1
      when(lastPlace) {
        place := 0
        count := count + 1
        when(count === scala.math.max(inputs.size - 1, 0))(goto(fetch))
      }
    }
    private val waits = Seq.fill(if (fast) RaySetupTiming.Waits else 0)(new State)
    private val settled = (waits :+ start).head
    for ((s, next) <- waits.zip(waits.drop(1) :+ start)) s.whenIsActive(goto(next))
    fetch.whenIsActive { when(pc === end)(goto(idle)).otherwise(goto(settled)) }
    start.whenIsActive {
      now.start := True
      now.top := True
      place := 0
      bitPlace := topBit
      goto(first)
      when(multiplying) {
        place := (topBit >> digitLog).resized
        readAddress := b
        goto(bit)
      }
    }
    // The multiplier has been read: its bit, then the result so far.
    bit.whenIsActive {
      now.bit := True
      place := 0
      readAddress := to
      goto(first)
    }
    first.whenIsActive {
      now.first := True
      readAddress := Mux(multiplying, a, b)
      goto(second)
    }
    second.whenIsActive {
      now.second := True
      place := place + 1
      readAddress := Mux(multiplying, to, a)
      goto(first)
      when(lastPlace) {
        pc := pc + 1
        goto(fetch)
        when(multiplying && bitPlace =/= 0) {
          pc := pc
          bitPlace := bitPlace - 1
          now.top := False
          place := ((bitPlace - 1) >> digitLog).resized
          readAddress := b
          goto(bit)
        }
      }
    }
    load.whenIsActive {
      readAddress := count.resized
      loading := True
      count := count + 1
      when(count === loadWords - 1) {
        pc := frame.size
        end := steps.size
        goto(fetch)
      }
    }
    always {
      when(io.line) { count := 0; goto(load) }
      when(io.latch) {
        count := 0
        place := 0
        pc := 0
        end := frame.size
        goto(take)
      }
    }
    io.busy := !isActive(idle)
  }
}
