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
  val lastVertex = vertex === 2

  // What the step does: read one clock ahead.
  val nextVertex = UInt(2 bits)
  val nextStep   = UInt(4 bits)
  nextVertex := vertex
  nextStep := step
  vertex := nextVertex
  step := nextStep
  val table  = Mem(StepWord(), (0 until 64).map(n => StepWord.of(n / 16, n % 16)))
  table.addAttribute("ram_style", "block")
  val action = table.readSync(nextVertex @@ nextStep)

  // Store reads: the vertices' indices, the three exponents, then word after word of each vertex.
  val vertices = Vec.fill(3)(Reg(UInt(10 bits)))
  val index    = vertices(vertex.resized).resize(layout.bankAddressBits)
  val awaiting = RegInit(False) clearWhen io.store.rsp.valid
  val wanted   = (state === State.Exponents) ? U(ExponentWord, 3 bits) | action.word
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

  io.read := (state === State.Write) ? action.nextOrigin | action.origin

  // The field, scaled, less vertex 0's.
  val centre = word(31 downto 16).asSInt - 8 // pixel centres become multiples of 16
  val behind = largest - exponents(vertex)
  io.scale := action.field === Field.Scale.id
  io.scaleShift := (behind > 30) ? U(0, 5 bits) | (30 - behind)
  val field = action.field.mux(
    Field.Position.id -> centre.resize(32),
    Field.Z.id        -> (word(31 downto 16).asUInt.resize(32).asSInt |<< 15),
    Field.Q.id        -> (word(31 downto 16).asUInt.resize(32).asSInt |<< 1),
    Field.Color.id    -> (word(31 downto 24).asUInt.resize(32).asSInt |<< 7),
    default           -> (word(24 downto 0).asSInt.resize(32) |<< 6)
  )
  val working    = state === State.Write
  val minuend    = working ? field | (io.pixel << 4).intoSInt.resize(32)
  val difference = minuend - io.readData
  val raise      = working ? action.upper | io.upper
  io.write.valid := working && action.field =/= Field.Skip.id
  io.write.word := action.target
  io.write.data := raise ? (difference |<< 16) | difference

  io.done := False
  switch(state) {
    is(State.Idle) {
      nextVertex := 0
      nextStep := 0
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
        nextVertex := lastVertex ? U(0) | vertex + 1
        when(lastVertex) { state := State.Read }
      }
    }
    is(State.Read) { when(io.store.cmd.fire) { state := State.Wait } }
    is(State.Wait) { when(io.store.rsp.valid) { state := State.Write } }
    is(State.Write) {
      nextStep := step + 1
      when(action.take) { word := word |<< 8 }
      when(action.lastOfWord) { state := State.Read }
      when(action.lastOfVertex) {
        nextStep := 0
        nextVertex := vertex + 1
        when(lastVertex) {
          state := State.Idle
          io.done := True
        }
      }
    }
  }
}

/** A step of [[SetupFetch.steps]] for one vertex, as the table holds it. */
case class StepWord() extends Bundle {
  val target, origin, nextOrigin = UInt(6 bits)
  val field                      = UInt(3 bits)
  val word                       = UInt(3 bits)
  val upper, take                = Bool()
  val lastOfWord, lastOfVertex   = Bool()
}

object StepWord {
  import SetupFetch._
  def of(vertex: Int, number: Int): StepWord = {
    val known = vertex < 3 && number < steps.length
    val s     = steps(if (known) number else 0)
    def originOf(n: Int) = if (vertex == 0 || n >= steps.length) Nothing else steps(n).origin.getOrElse(Nothing)
    val w = StepWord()
    w.target := s.targets(if (known) vertex else 0)
    w.origin := originOf(number)
    w.nextOrigin := originOf(number + 1)
    w.field := s.field.id
    w.word := s.word
    w.upper := Bool(s.upper && vertex > 0)
    w.take := Bool(s.take)
    w.lastOfWord := Bool(number + 1 >= steps.length || steps(number + 1).word != s.word)
    w.lastOfVertex := Bool(number + 1 >= steps.length)
    w
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
}
