package frustum.ray

import frustum.spec.{RayProgram, RayStep}
import spinal.core._
import spinal.lib._
import spinal.lib.fsm._

/** Runs a [[frustum.spec.RayProgram]]: one memory of words, an adder, and a multiplier that takes a bit a clock.
  *
  * `latch` takes the inputs and makes the frame's coefficients, `frameClocks` long. `line` gives the words
  * of the row to come, one a clock, in `lineClocks`, then moves the state on to the next row in `rowClocks`.
  * A `line` or `latch` while busy cuts off what runs.
  */
case class RaySetup(program: RayProgram) extends Component {
  import program._
  val io = new Bundle {
    val latch, line = in Bool ()
    val inputs      = in(Vec(program.inputs.map(i => SInt(i.range.width bits))))
    val load        = master(Flow(RayRegisterLoad(program)))
    val busy        = out Bool ()
  }
  private val addressBits = log2Up(words.size)
  private val steps       = frame ++ row
  private val multiplies  = frame.count(_.op == RayStep.Multiply)
  require(!row.exists(_.op == RayStep.Multiply), "a row's steps are additions")

  val frameClocks: Int = inputs.size + frame.size * RaySetup.StepClocks + multiplies * wordWidth + 2
  val lineClocks: Int  = loadWords + 4
  val rowClocks: Int   = row.size * RaySetup.StepClocks + 2

  private val initial = words.map(w => w.constant.getOrElse(BigInt(0)) & ((BigInt(1) << wordWidth) - 1))
  val memory          = Mem(Bits(wordWidth bits), words.size).initBigInt(initial)
  private def encoded(s: RayStep): BigInt =
    ((BigInt(s.op) << addressBits | s.to) << addressBits | s.a) << addressBits | s.b
  val steprom = Mem(Bits(2 + 3 * addressBits bits), steps.size).initBigInt(steps.map(encoded))

  val latched      = Vec(io.inputs.map(v => RegNextWhen(v, io.latch)))
  val pc, end      = Reg(UInt(log2Up(steps.size + 1) bits))
  val count        = Reg(UInt(log2Up(wordWidth.max(loadWords + 1).max(inputs.size + 1)) bits))
  val a, b, result = Reg(Bits(wordWidth bits))

  val readAddress  = UInt(addressBits bits)
  val read         = memory.readSync(readAddress)
  val writing      = False
  val writeAddress = UInt(addressBits bits)
  val writeData    = Bits(wordWidth bits)
  memory.write(writeAddress, writeData, writing)
  val instruction = steprom.readSync(pc.resize(log2Up(steps.size)))
  val op          = instruction(3 * addressBits, 2 bits).asUInt
  val to          = instruction(2 * addressBits, addressBits bits).asUInt
  readAddress  := instruction(addressBits, addressBits bits).asUInt
  writeAddress := to
  writeData    := result

  val loading = RegNext(False) init False
  io.load.valid := loading
  io.load.index := RegNext(count.resize(io.load.index.getWidth))
  io.load.data  := read

  val fsm = new StateMachine {
    val idle                                                        = makeInstantEntry()
    val take, fetch, readA, readB, calculate, multiply, write, load = new State
    take.whenIsActive {
      if (inputs.nonEmpty) {
        writing := True
        writeData.assignFromBits(
          Vec(latched.map(_.resize(wordWidth).asBits)).read(count.resize(log2Up(inputs.size.max(2))))
        )
        writeAddress := Vec(
          inputs.map(i => U(i.address, addressBits bits))
        ).read(count.resize(log2Up(inputs.size.max(2))))
      }
      count := count + 1
      when(count === scala.math.max(inputs.size - 1, 0)) { goto(fetch) }
    }
    fetch.whenIsActive { when(pc === end)(goto(idle)).otherwise(goto(readA)) }
    readA.whenIsActive(goto(readB))
    readB.whenIsActive {
      a           := read
      readAddress := instruction(0, addressBits bits).asUInt
      goto(calculate)
    }
    calculate.whenIsActive {
      b      := read
      result := Mux(
        op === RayStep.Multiply,
        B(0, wordWidth bits),
        Mux(op === RayStep.Add, a.asUInt + read.asUInt, a.asUInt - read.asUInt).asBits
      )
      count := 0
      when(op === RayStep.Multiply)(goto(multiply)).otherwise(goto(write))
    }
    multiply.whenIsActive {
      when(b(0))(result := (result.asUInt + a.asUInt).asBits)
      a     := a |<< 1
      b     := b |>> 1
      count := count + 1
      when(count === wordWidth - 1)(goto(write))
    }
    write.whenIsActive {
      writing := True
      pc      := pc + 1
      goto(fetch)
    }
    load.whenIsActive {
      readAddress := (count.resize(addressBits) + program.load).resized
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
        pc    := 0
        end   := frame.size
        goto(if (inputs.isEmpty) fetch else take)
      }
    }
    io.busy := !isActive(idle)
  }
}

object RaySetup {

  /** Clocks of a step besides a multiplication's bits: fetch, two reads, calculate, write. */
  val StepClocks = 5
}

/** Word `index` of the row load. */
case class RayRegisterLoad(program: RayProgram) extends Bundle {
  val index = UInt(log2Up(program.loadWords) bits)
  val data  = Bits(program.wordWidth bits)
}
