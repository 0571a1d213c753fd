package frustum.raster

import frustum.blackbox.{ComplementingAdder, Tech}
import frustum.fixed.Multiplier16
import frustum.spec.{SetupInstruction, SetupProgram, SetupWords}
import spinal.core._
import spinal.lib._

/** A result on its way from the engine to whoever takes it. */
case class SetupResult() extends Bundle {
  val kind   = UInt(3 bits) // SetupInstruction.Result.code
  val target = UInt(6 bits)
  val value  = SInt(32 bits)
}

/** Runs a section of [[frustum.spec.SetupProgram]] on one slot of its scratch memory: one multiply-accumulate of 32 by 32
  * bits in two clocks, from one read port (first `b`, then `a`).
  *
  * Between runs (`idle`) the scratch memory belongs to `write` and `read`; data is on `readData` one clock after `read`.
  *
  * @param slots triangles that the scratch memory holds, beside the words that all share
  */
case class SetupEngine(slots: Int, tech: Tech) extends Component {
  import SetupInstruction._

  val sectionBits = log2Up(SetupProgram.sections.length)
  val words = SetupWords.SharedWords + slots * SetupWords.SlotWords
  val io = new Bundle {
    val run      = slave Flow (UInt(sectionBits bits))
    val slot     = in UInt (log2Up(slots) bits)
    val sliver   = in Bool () // gradients are integers, not fractions
    val idle     = out Bool ()
    val write    = slave Flow (ScratchWrite())
    val read     = in UInt (6 bits)
    val readData = out SInt (32 bits)
    val result   = master Flow (SetupResult())
    val overflow = out Bool () // a checked result did not fit, since the last run began
    /** `b` of an edge's product with `Left` or `Top`, negated where the product is subtracted. */
    val step     = master Flow (SInt(17 bits))
  }

  // An instruction takes two clocks, phases 0 and 1. Its word appears at the ROM's output in phase 0.
  val image   = SetupProgram.image
  val pcBits  = log2Up(image.length + 1)
  val phase   = RegInit(False)
  phase := !phase
  val pc, end = Reg(UInt(pcBits bits))
  val running, executing = RegInit(False)
  val fetch = running && pc =/= end
  when(phase) {
    executing := fetch
    running := fetch
    when(fetch) { pc := pc + 1 }
  }
  when(io.run.valid) {
    def table(of: Seq[Int]) = Vec(of.map(U(_, pcBits bits)))(io.run.payload)
    pc := table(SetupProgram.starts.init)
    end := table(SetupProgram.starts.tail)
    running := True
  }
  val rom  = Mem(Bits(WordBits bits), image.map(i => B(encode(i), WordBits bits)))
  val word = rom.readSync(pc.resized, enable = phase)

  class Control extends Bundle {
    val subtract = Bool()
    val start    = UInt(2 bits)
    val target   = UInt(6 bits)
    val kind     = UInt(3 bits)
  }
  val instruction = new Control
  instruction.assignFromBits(word(12, 12 bits))
  val wordA = word(0, 6 bits).asUInt
  val wordB = word(6, 6 bits).asUInt

  // Clock 0 reads b, clock 1 a. An edge's walk starts at the side from which its function grows.
  val scratch = Mem(SInt(32 bits), words)
  scratch.init((0 until words).map(n => S(SetupWords.constants.getOrElse(n + SetupWords.Shared, 0), 32 bits)))
  val bases = Vec((0 until slots).map(n => U(SetupWords.SharedWords + n * SetupWords.SlotWords, log2Up(words) bits)))
  val slotBase = bases(io.slot)
  def address(word: UInt): UInt = {
    val shared = word >= SetupWords.Shared
    (shared ? U((-SetupWords.Shared) & ((1 << log2Up(words)) - 1), log2Up(words) bits) | slotBase) + word
  }
  val readWord = UInt(6 bits)
  val data     = scratch.readSync(address(readWord), readUnderWrite = dontCare)
  val atLeft   = wordA === SetupWords.Left
  val atTop    = wordA === SetupWords.Top
  readWord := io.read
  when(executing) {
    readWord := phase ? wordA | wordB
    when(phase && atLeft && data.msb =/= instruction.subtract) { readWord := SetupWords.Right }
  }
  io.readData := data

  val operandStep = (data >> 16).resize(17)
  io.step.valid := executing && phase && (atLeft || atTop)
  io.step.payload := instruction.subtract ? -operandStep | operandStep

  // Clocks 3 and 4 multiply a by b's signed lower half and by its upper half, rounded up to make good for the sign.
  val b      = RegNextWhen(data, phase)
  val a      = RegNextWhen(data, !phase)
  val bUpper = RegNext((b(31 downto 16).asUInt + b(15).asUInt).asBits)
  val bHalf  = phase ? b(15 downto 0).asBits | bUpper
  val low    = Multiplier16(tech, signedA = false, signedB = true)
  val high   = Multiplier16(tech, signedA = true, signedB = true)
  low.io.a := a(15 downto 0).asBits
  high.io.a := a(31 downto 16).asBits
  Seq(low, high).foreach { m => m.io.enable := True; m.io.b := bHalf }

  // The instruction's control follows: stage n is valid in clocks 2 n and 2 n + 1.
  val valids   = History(executing, 5, phase, False).tail
  val controls = History(instruction, 5, phase).tail
  def control(clock: Int) = controls(clock / 2 - 1)

  // Clocks 5 and 6 add the partial products (complemented to subtract), clocks 6 and 7 accumulate.
  val complement = phase ? control(5).subtract | control(6).subtract
  val upperSum   = ComplementingAdder(32, tech)
  upperSum.io.complement := complement
  upperSum.io.a := high.io.product.asSInt
  upperSum.io.b := (low.io.product.asSInt >> 16).resize(32)
  val product = RegNext(upperSum.io.result @@ (low.io.product(15 downto 0) ^ B(16 bits, default -> complement)).asSInt)
  val accumulator = Reg(SInt(48 bits))
  val start = SInt(48 bits)
  start := accumulator
  when(!phase && control(6).start =/= Keep.code) {
    start := 0
    start(13) := control(6).start === Round.code || control(6).start === RoundGradient.code && !io.sliver
  }
  val addend = phase ? product | (product >> 16).resize(48)
  accumulator := start + addend + control(6).subtract.asUInt.resize(48).asSInt

  // Clock 8 hands the result on.
  val done    = valids(3) && !phase
  val kind    = control(8).kind
  def is(kinds: Int*) = kinds.map(kind === _).orR
  val gradient = is(GradientX(0).code, GradientY(0).code)
  val fraction = is(Fraction(0).code, Initial(0).code) || gradient && !io.sliver
  val value    = fraction ? accumulator(14, 32 bits) | accumulator(0, 32 bits)
  val toScratch = is(Integer(0).code, Fraction(0).code, Checked(0).code)
  io.result.valid := done && kind =/= Nowhere.code
  io.result.kind := kind
  io.result.target := control(8).target
  io.result.value := value
  scratch.write(
    address(done ? control(8).target | io.write.word),
    done ? value | io.write.data,
    enable = done ? toScratch | io.write.valid
  )

  val overflow = RegInit(False)
  val upper    = accumulator(47 downto 29)
  overflow.setWhen(done && is(Checked(0).code) && upper.orR && !upper.andR)
  overflow.clearWhen(io.run.valid)
  io.overflow := overflow
  io.idle := !running && !executing && !valids.take(4).orR
}
