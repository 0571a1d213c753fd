package frustum.ray

import frustum.spec.RayStep
import spinal.core._
import spinal.lib._
import spinal.lib.fsm._

/** Runs a [[frustum.spec.RayProgram]] on one memory, whose words are read whole and written a digit at a time, and one adder of
  * a digit. A multiplication takes its second operand's bits from the top, doubles what it has and adds the first operand or not.
  *
  * `latch` takes the inputs, which must stay for `takeClocks`, and makes the frame's coefficients, `frameClocks` long. `line`
  * gives the words of the row to come, one a clock, in `lineClocks`, then moves the state on to the next row in `rowClocks`,
  * see [[RaySetupTiming]]. A `line` or `latch` while busy cuts off what runs.
  */
case class RaySetup(timing: RaySetupTiming) extends Component {
  import timing._
  import timing.program._
  val io = new Bundle {
    val latch, line = in Bool ()
    val inputs      = in(Vec(program.inputs.map(i => SInt(i.range.width bits))))
    val load        = out(RayRowLoad(program))
    val busy        = out Bool ()
  }
  private val width       = digits * digitBits
  private val addressBits = log2Up(size)
  private val bitBits     = log2Up(width)
  private val digitLog    = log2Up(digitBits)
  private val steps       = frame ++ row
  require(!row.exists(_.op == RayStep.Multiply), "a row's steps are additions")

  private def digit(v: BigInt, d: Int) = v >> (d * digitBits) & ((BigInt(1) << digitBits) - 1)
  val columns                          = Seq.tabulate(digits) { d =>
    Mem(
      Bits(digitBits bits),
      size
    ).initBigInt((0 until size).map(a => digit(constants.getOrElse(a, BigInt(0)), d)))
  }
  private def encoded(s: RayStep): BigInt =
    Seq(
      s.op                    -> 2,
      (multiplierBits(s) - 1) -> bitBits,
      s.to                    -> addressBits,
      s.a                     -> addressBits,
      s.b                     -> addressBits
    )
      .foldLeft(BigInt(0)) { case (word, (v, bits)) => word << bits | v }
  val steprom     = Mem(Bits(2 + bitBits + 3 * addressBits bits), steps.size).initBigInt(steps.map(encoded))
  val pc, end     = Reg(UInt(log2Up(steps.size + 1) bits))
  val instruction = steprom.readSync(pc.resize(log2Up(steps.size)))
  private def address(place: Int) = instruction(place * addressBits, addressBits bits).asUInt
  private val (b, a, to)          = (address(0), address(1), address(2))
  private val topBit              = instruction(3 * addressBits, bitBits bits).asUInt
  private val op                  = instruction(3 * addressBits + bitBits, 2 bits).asUInt
  private val multiplying         = op === RayStep.Multiply

  val count                             = Reg(UInt(log2Up(loadWords.max(inputs.size).max(2)) bits))
  val place                             = Reg(UInt(bitBits - digitLog bits)) // of the digit
  val bitPlace                          = Reg(UInt(bitBits bits))
  private val lastPlace                 = if (digits == 1) True else place === digits - 1
  private def digitOf(word: Bits): Bits = {
    val all = Vec.tabulate(digits)(d => word(d * digitBits, digitBits bits))
    if (digits == 1) all.head else all.read(place.resize(log2Up(digits)))
  }
  val readAddress = CombInit(a)
  val read        = columns.map(_.readSync(readAddress)).reverse.reduce(_ ## _)

  /** The adder: `first` waits for the second operand, which comes from the memory. */
  val alu = new Area {
    val first     = Reg(UInt(digitBits bits))
    val shiftedIn = Reg(Bool()) // what the digit below gives when doubled
    val carry     = Reg(Bool())
    val bit       = Reg(Bool()) // of the multiplier
    val top       = Reg(Bool()) // the highest, which counts negative
    val subtract  = Mux(multiplying, top, op === RayStep.Subtract)
    val doubled   = Mux(multiplying, (first ## shiftedIn).asUInt.resize(digitBits), first)
    val gate      = !multiplying || bit
    val second    =
      (digitOf(read).asUInt & U(digitBits bits, default -> gate)) ^ U(digitBits bits, default -> subtract)
    val sum = (doubled +^ second) + carry.asUInt
  }
  val writing      = False
  val writeAddress = CombInit(to)
  val writeData    = CombInit(alu.sum.resize(digitBits).asBits)
  // Registers mean nothing before their first clock under reset: the constants must outlast it.
  private val writes = writing && !ClockDomain.current.isResetActive
  for ((column, d) <- columns.zipWithIndex)
    column.write(writeAddress, writeData, if (digits == 1) writes else writes && place === d)

  val loading = RegNext(False) init False
  io.load.clear := RegNext(io.line) init False
  io.load.valid := loading
  io.load.index := RegNext(count.resize(io.load.index.getWidth))
  io.load.data  := read.resized

  val fsm = new StateMachine {
    val idle                                         = makeInstantEntry()
    val take, fetch, start, bit, first, second, load = new State
    take.whenIsActive {
      if (inputs.nonEmpty) {
        val at = count.resize(log2Up(inputs.size.max(2)))
        writing      := True
        writeData    := digitOf(Vec(io.inputs.map(_.resize(width).asBits)).read(at))
        writeAddress := Vec(inputs.map(i => U(i.address, addressBits bits))).read(at)
      }
      place := place + 1
      when(lastPlace) {
        place := 0
        count := count + 1
        when(count === scala.math.max(inputs.size - 1, 0))(goto(fetch))
      }
    }
    fetch.whenIsActive { when(pc === end)(goto(idle)).otherwise(goto(start)) }
    start.whenIsActive {
      place     := 0
      alu.top   := True
      alu.carry := op === RayStep.Subtract
      bitPlace  := topBit
      goto(first)
      when(multiplying) {
        place       := (topBit >> digitLog).resized
        readAddress := b
        goto(bit)
      }
    }
    // The multiplier has been read: its bit, then the result so far.
    bit.whenIsActive {
      alu.bit       := digitOf(read)(bitPlace.resize(digitLog))
      alu.carry     := alu.top
      alu.shiftedIn := False
      place         := 0
      readAddress   := to
      goto(first)
    }
    first.whenIsActive {
      alu.first   := digitOf(read).asUInt
      when(multiplying && alu.top)(alu.first := 0)
      readAddress := Mux(multiplying, a, b)
      goto(second)
    }
    second.whenIsActive {
      writing       := True
      alu.carry     := alu.sum.msb
      alu.shiftedIn := alu.first.msb
      place         := place + 1
      readAddress   := Mux(multiplying, to, a)
      goto(first)
      when(lastPlace) {
        pc := pc + 1
        goto(fetch)
        when(multiplying && bitPlace =/= 0) {
          pc          := pc
          bitPlace    := bitPlace - 1
          alu.top     := False
          place       := ((bitPlace - 1) >> digitLog).resized
          readAddress := b
          goto(bit)
        }
      }
    }
    load.whenIsActive {
      readAddress := count.resized
      loading     := True
      count       := count + 1
      when(count === loadWords - 1) {
        pc  := frame.size
        end := steps.size
        goto(fetch)
      }
    }
    always {
      when(io.line) { count := 0; goto(load) }
      when(io.latch) {
        count := 0
        place := 0
        pc    := 0
        end   := frame.size
        goto(take)
      }
    }
    io.busy := !isActive(idle)
  }
}
