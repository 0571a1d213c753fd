package frustum.raster.setup

import frustum.arithmetic.Multiplier16
import frustum.contract.raster.{SetupInstruction, SetupMemory, SetupProgram, SetupWords}
import frustum.device.{ComplementingAdder, Tech}
import spinal.core._
import spinal.lib._

/** A result that leaves the engine. */
case class SetupResult() extends Bundle {
  val kind = UInt(3 bits) // SetupInstruction.Result.code
  val target = UInt(SetupMemory.CodeBits bits) // a word's code, a plane or an edge
  val value = SInt(32 bits)
}

/** Runs a section of [[frustum.contract.raster.SetupProgram]] on one slot of its scratch memory: one
  * multiply-accumulate of 32 by 32 bits in two cycles, from one read port (first `b`, then `a`).
  *
  * Between runs (`idle`) the scratch memory belongs to `write` and `read`; data is on `readData` one cycle after
  * `read`.
  *
  * @param slots  triangles that the scratch memory holds, beside the words that all share
  * @param planes that are needed
  */
case class SetupEngine(slots: Int, tech: Tech = Tech.Generic, planes: Seq[Int] = SetupWords.AllPlanes)
    extends Component {
  import SetupInstruction._
  import SetupMemory.CodeBits

  val program = SetupProgram(planes)
  val memory = SetupMemory(planes)
  val sectionBits = log2Up(program.sections.length)
  // Slots of 32 words at most are one after the other, before the shared words: an address is concatenated, not added.
  private val slotWords = memory.slotWords
  private val aligned = slotWords <= 32
  private val shared = if (aligned) slots * 32 else 0
  val words = memory.sharedWords + slots * (if (aligned) 32 else slotWords)
  val io = new Bundle {
    val run = slave(Flow(UInt(sectionBits bits)))
    val slot = in UInt (log2Up(slots) bits)
    val sliver = in Bool () // gradients are integers, not fractions
    val idle = out Bool ()
    val write = slave(Flow(ScratchWrite()))
    val read = in UInt (SetupMemory.CodeBits bits)
    val readData = out SInt (32 bits)
    val result = master(Flow(SetupResult()))
    val overflow = out Bool () // a checked result did not fit, since the last run began
    /** `b` of an edge's product with `Left` or `Top`, negated where the product is subtracted. */
    val step = master(Flow(SInt(17 bits)))
  }

  // An instruction takes two cycles, phases 0 and 1. Its word appears at the ROM's output in phase 0.
  val image = program.image
  val pcBits = log2Up(image.length + 1)
  val phase = RegInit(False)
  phase := !phase
  val pc, end = Reg(UInt(pcBits bits))
  val running, executing = RegInit(False)
  val more = RegNext(pc =/= end) // pc has been constant for a cycle when it is compared
  val fetch = running && more
  when(phase) {
    executing := fetch
    running := fetch
    when(fetch) { pc := pc + 1 }
  }
  when(io.run.valid) {
    def table(of: Seq[Int]) = Vec(of.map(U(_, pcBits bits)))(io.run.payload)
    pc := table(program.starts.init)
    end := table(program.starts.tail)
    more := True
    running := True
  }
  val rom = Mem(Bits(WordBits bits), image.map(i => B(encode(i, memory), WordBits bits)))
  val word = rom.readSync(pc.resized, enable = phase)

  class Control extends Bundle {
    val subtract = Bool()
    val start = UInt(2 bits)
    val target = UInt(CodeBits bits)
    val kind = UInt(3 bits)
  }
  val instruction = new Control
  instruction.assignFromBits(word(14, 13 bits))
  val wordA = word(0, CodeBits bits).asUInt
  val wordB = word(CodeBits, CodeBits bits).asUInt
  val atLeft = word(27)
  val atTop = word(28)
  val far = word(29)

  // Cycle 0 reads b, cycle 1 a. An edge's walk starts at the side from which its function grows.
  val scratch = Mem(SInt(32 bits), words)
  scratch.init((0 until words).map(n => S(memory.initial.applyOrElse(n - shared, (_: Int) => 0), 32 bits)))
  val bases = Vec((0 until slots).map(n => U(memory.sharedWords + n * slotWords, log2Up(words) bits)))
  val slotBase = RegNext(if (aligned) io.slot else bases(io.slot))
  def address(code: UInt): UInt =
    if (aligned) (Mux(code.msb, U(slots, log2Up(words) - 5 bits), slotBase.resized) @@ code(4 downto 0))
    else Mux(code.msb, U(0, log2Up(words) bits), slotBase) + code(CodeBits - 2 downto 0)
  val readWord = UInt(CodeBits bits)
  val data = scratch.readSync(address(readWord), readUnderWrite = dontCare)
  readWord := Mux(executing, Mux(phase, wordA, wordB), io.read)
  val falls = data.msb =/= instruction.subtract // the product falls where `a` grows
  when(executing && phase && (atLeft && falls =/= far || atTop && far && !falls)) {
    readWord.lsb := True
  } // Right, Bottom
  io.readData := data

  val operandStep = (data >> 16).resize(17)
  io.step.valid := executing && phase && (atLeft || atTop) && !far
  io.step.payload := Mux(instruction.subtract, -operandStep, operandStep)

  // Cycles 2 and 3 give the multipliers a, and b's signed lower half, then its upper half, rounded up to compensate for
  // the sign.
  val bUpper = RegNextWhen((data(31 downto 16).asUInt + data(15).asUInt).asBits, phase)
  val bHalf = RegNext(Mux(phase, data(15 downto 0).asBits, bUpper))
  val low = Multiplier16(tech, signedA = false, signedB = true, hold = true)
  val high = Multiplier16(tech, signedA = true, signedB = true, hold = true)
  low.io.a := data(15 downto 0).asBits
  high.io.a := data(31 downto 16).asBits
  Seq(low, high).foreach { m => m.io.enable := True; m.io.b := bHalf; m.io.holdA := phase }

  // The instruction's control follows: stage n is valid in cycles 2 n and 2 n + 1.
  val valids = History(executing, 4, phase, False).tail
  val controls = History(instruction, 4, phase).tail
  def control(clock: Int) = controls(clock / 2 - 1)

  // Cycles 4 and 5 add the partial products (complemented to subtract), cycles 5 and 6 accumulate: the lower half of
  // b's first, 16 bits lower.
  val complement = control(4).subtract
  val upperSum = ComplementingAdder(32, tech)
  upperSum.io.complement := complement
  upperSum.io.a := high.io.product.asSInt
  upperSum.io.b := (low.io.product.asSInt >> 16).resize(32)
  val product = upperSum.io.result @@ (low.io.product(15 downto 0) ^ B(16 bits, default -> complement)).asSInt
  val addend = RegNext(Mux(phase, product, (product >> 16).resize(48)))
  val carry = RegNext(complement)
  val accumulator = Reg(SInt(48 bits))
  val start = SInt(48 bits)
  val fresh = RegNext(!phase && control(4).start =/= Keep.code)
  val round = RegNext(control(4).start === Round.code || control(4).start === RoundGradient.code && !io.sliver)
  start := accumulator
  when(fresh) {
    start := 0
    start(13) := round
  }
  accumulator := start + addend + carry.asUInt.resize(48).asSInt

  // In cycle 7 the result leaves.
  val done = valids(2) && phase
  private val any = SetupWords.Nothing
  val kind = control(7).kind
  def is(kinds: Int*) = kinds.map(kind === _).orR
  val gradient = is(GradientX(0).code, GradientY(0).code)
  val fraction = is(Fraction(any).code, Initial(0).code) || gradient && !io.sliver
  val value = Mux(fraction, accumulator(14, 32 bits), accumulator(0, 32 bits))
  val toScratch = is(Integer(any).code, Fraction(any).code, Checked(any).code)
  io.result.valid := done && kind =/= Nowhere.code
  io.result.kind := kind
  io.result.target := control(7).target
  io.result.value := value
  scratch.write(
    address(Mux(done, control(7).target, io.write.word)),
    Mux(done, value, io.write.data),
    // Before their first cycle under reset registers are undefined: the constants must keep their values.
    enable = Mux(done, toScratch, io.write.valid) && !ClockDomain.current.isResetActive
  )

  val overflow = RegInit(False)
  val upper = accumulator(47 downto 29)
  overflow.setWhen(done && is(Checked(any).code) && upper.orR && !upper.andR)
  overflow.clearWhen(io.run.valid)
  io.overflow := overflow
  io.idle := !running && !executing && !valids.orR
}
