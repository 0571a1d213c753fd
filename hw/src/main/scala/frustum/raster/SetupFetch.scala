package frustum.raster

import frustum.link.StoreBus
import frustum.spec.{SetupWords, StoreLayout}
import frustum.spec.SetupWords._
import spinal.core._
import spinal.lib._

/** A word for the set-up engine's scratch memory. */
case class ScratchWrite() extends Bundle {
  val word = UInt(6 bits)
  val data = SInt(32 bits)
}

/** Brings a triangle's three vertices from the store into the set-up engine's scratch memory: vertex 0's fields and the
  * differences of the others', in the scales that [[frustum.spec.SetupProgram]] takes, one word a clock and three clocks
  * a store word. Begins with `start`, ends with a pulse on `done`.
  *
  * Its subtractor also serves others while it is idle: `write.data` is then the place of `pixel` less `readData`.
  */
case class SetupFetch(layout: StoreLayout) extends Component {
  import SetupFetch._
  val io = new Bundle {
    val start    = in Bool ()
    val triangle = in UInt (10 bits)
    val bank     = in UInt (1 bits)
    val done     = out Bool ()
    val store    = master(StoreBus(layout))
    val write    = master Flow (ScratchWrite())
    val read     = out UInt (6 bits)
    val readData = in SInt (32 bits)
    val pixel    = in UInt (10 bits) // column or row; its place is in 1/16 pixel
    val upper    = in Bool () // the place times 2^16
    /** Instead of the data, 2^scaleShift is to be written. */
    val scale      = out Bool ()
    val scaleShift = out UInt (5 bits)
  }

  object State extends SpinalEnum { val Idle, Vertices, Exponents, Read, Wait, Write = newElement() }
  val state  = RegInit(State.Idle)
  val vertex = Reg(UInt(2 bits))
  val step   = Reg(UInt(4 bits))
  def perStep[T <: Data](of: Step => T): T = Vec(steps.map(of))(step.resized)
  val lastVertex = vertex === 2

  // Store reads: the vertices' indices, the three exponents, then word after word of each vertex.
  val vertices = Vec.fill(3)(Reg(UInt(10 bits)))
  val index    = vertices(vertex.resized).resize(layout.bankAddressBits)
  val awaiting = RegInit(False) clearWhen io.store.rsp.valid
  val wanted   = (state === State.Exponents) ? U(ExponentWord, 3 bits) | perStep(s => U(s.word, 3 bits))
  io.store.cmd.valid := (state === State.Vertices || state === State.Exponents || state === State.Read) && !awaiting
  io.store.cmd.write := False
  io.store.cmd.address := io.bank @@ ((index |<< 2) + index + wanted)
  when(state === State.Vertices) {
    io.store.cmd.address := io.bank @@
      (U(layout.triangles, layout.bankAddressBits bits) + (io.triangle << 1).resize(layout.bankAddressBits))
  }
  io.store.cmd.data := 0
  awaiting.setWhen(io.store.cmd.fire)
  // A store word; the next field is always at its top.
  val word = Reg(Bits(32 bits))
  when(io.store.rsp.valid) { word := io.store.rsp.payload }

  val exponents = Vec.fill(3)(Reg(UInt(5 bits)))
  val largest   = Reg(UInt(5 bits))
  val arriving  = io.store.rsp.payload(31 downto 27).asUInt

  val stepReadAhead = UInt(4 bits)
  stepReadAhead := (state === State.Write) ? (step + 1) | step
  io.read := Nothing
  when(vertex =/= 0) { io.read := Vec(steps.map(s => U(s.origin.getOrElse(Nothing), 6 bits)))(stepReadAhead.resized) }

  // The field, scaled, less vertex 0's.
  val centre = word(31 downto 16).asSInt - 8 // pixel centres become multiples of 16
  val behind = largest - exponents(vertex)
  io.scale := perStep(s => Bool(s.field == Field.Scale))
  io.scaleShift := (behind > 30) ? U(0, 5 bits) | (30 - behind)
  val field = perStep { s =>
    s.field match {
      case Field.Position => centre.resize(32)
      case Field.Z        => word(31 downto 16).asUInt.resize(32).asSInt |<< 15
      case Field.Q        => word(31 downto 16).asUInt.resize(32).asSInt |<< 1
      case Field.Color    => word(31 downto 24).asUInt.resize(32).asSInt |<< 7
      case _              => word(24 downto 0).asSInt.resize(32) |<< 6
    }
  }
  val working    = state === State.Write
  val minuend    = working ? field | (io.pixel << 4).intoSInt.resize(32)
  val difference = minuend - io.readData
  val raise      = working ? (perStep(s => Bool(s.upper)) && vertex =/= 0) | io.upper
  io.write.valid := working && perStep(s => Bool(s.field != Field.Skip))
  io.write.word := Vec((0 to 2).map(v => perStep(s => U(s.targets(v), 6 bits))))(vertex.resized)
  io.write.data := raise ? (difference |<< 16) | difference

  io.done := False
  switch(state) {
    is(State.Idle) {
      vertex := 0
      step := 0
      largest := 0
      when(io.start) { state := State.Vertices }
    }
    is(State.Vertices) {
      when(io.store.rsp.valid) {
        for (v <- 0 to 2) vertices(v) := io.store.rsp.payload(20 - 10 * v, 10 bits).asUInt
        state := State.Exponents
      }
    }
    is(State.Exponents) {
      when(io.store.rsp.valid) {
        exponents(vertex) := arriving
        when(arriving > largest) { largest := arriving }
        vertex := lastVertex ? U(0) | vertex + 1
        when(lastVertex) { state := State.Read }
      }
    }
    is(State.Read) { when(io.store.cmd.fire) { state := State.Wait } }
    is(State.Wait) { when(io.store.rsp.valid) { state := State.Write } }
    is(State.Write) {
      step := step + 1
      when(perStep(s => Bool(s.take))) { word := word |<< 8 }
      when(perStep(s => Bool(lastOfWord(s)))) { state := State.Read }
      when(step === steps.length - 1) {
        step := 0
        vertex := vertex + 1
        when(lastVertex) {
          state := State.Idle
          io.done := True
        }
      }
    }
  }
}

object SetupFetch {
  object Field extends Enumeration { val Position, Z, Q, Texture, Scale, Color, Skip = Value }

  /** One write of a vertex's field, which stands at the top of the store word, except for texture coordinates.
    *
    * @param word    which of the vertex's store words holds it
    * @param targets scratch word for vertices 0, 1 and 2
    * @param take    the store word's top byte is done with
    * @param origin  vertex 0's value, subtracted for vertices 1 and 2
    * @param upper   differences are written times 2^16
    */
  final case class Step(
      word: Int,
      field: Field.Value,
      targets: Seq[Int],
      take: Boolean = false,
      origin: Option[Int] = None,
      upper: Boolean = false
  )

  private def position(targets: Seq[Int], take: Boolean, upper: Boolean, origin: Int) =
    Step(0, Field.Position, targets, take, Some(origin), upper)
  private def plane(word: Int, field: Field.Value, p: Int) =
   
    Step(word, field, Seq(value(p), delta1(p), delta2(p)), take = true, Some(value(p)))

  private def skip(word: Int) = Step(word, Field.Skip, Seq(Nothing, Nothing, Nothing), take = true)

  // What vertex 0 leaves in a difference's place, vertex 1 overwrites.
  val steps: Seq[Step] = Seq(
    position(Seq(X0, DX1, DX2), take = false, upper = false, X0),
    position(Seq(DX1_16, DX1_16, DX2_16), take = true, upper = true, X0),
    skip(0),
    position(Seq(Y0, DY1_16, DY2_16), take = false, upper = true, Y0),
    plane(1, Field.Z, PlaneZ),
    skip(1),
    Step(1, Field.Q, (0 to 2).map(q)),
    Step(2, Field.Texture, (0 to 2).map(s)),
    Step(2, Field.Scale, (0 to 2).map(scale)),
    Step(3, Field.Texture, (0 to 2).map(t)),
    plane(4, Field.Color, PlaneR),
    plane(4, Field.Color, PlaneG),
    plane(4, Field.Color, PlaneB),
    plane(4, Field.Color, PlaneA)
  )
  val ExponentWord = 2

  private def lastOfWord(s: Step): Boolean = {
    val next = steps.indexWhere(_ eq s) + 1
    next == steps.length || steps(next).word != s.word
  }
}
