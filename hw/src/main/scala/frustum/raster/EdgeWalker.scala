package frustum.raster

import frustum.spec.RasterConfig
import spinal.core._
import spinal.lib._

/** Pixels `first` to `last` of row `y` of the tile, inclusive; or, with `end`, no pixels and no more of the triangle. */
case class Span(config: RasterConfig) extends Bundle {
  val y           = UInt(config.tileLog2Height bits)
  val first, last = UInt(config.tileLog2Width bits)
  val end         = Bool()
}

/** Finds the pixels of a triangle in a tile: from the top row down, each row's span, then the end mark.
  *
  * Each of the three edge functions tracks how many pixels it cuts off its side of the row (left where the function grows
  * to the right), stepping inwards or outwards from the row above, all three at once. So a row costs two clocks and the
  * largest lateral move of an edge, and is found while the row before is being drawn. Top-left rule (Pineda 1988, with
  * integer edge functions at pixel centres): an exact zero is inside for a top or left edge alone.
  *
  * To load, while `idle`: per edge its steps per 1/16 pixel (x then y, edge after edge) and its function in the top row,
  * at the left column or, where the x step is negative, at `lastColumn`, in 1/256 pixel^2; then `start`.
  */
case class EdgeWalker(config: RasterConfig) extends Component {
  val io = new Bundle {
    val lastColumn = in UInt (config.tileLog2Width bits) // of the tile that lie on the screen
    val lastRow    = in UInt (config.tileLog2Height bits)
    val step   = slave Flow (SInt(17 bits))
    val edge   = slave Flow (new Bundle { val index = UInt(2 bits); val value = SInt(32 bits) })
    val start  = in Bool ()
    val idle   = out Bool ()
    val up     = master Stream (Span(config))
  }

  val cutBits = config.tileLog2Width + 1
  val width   = RegNext(io.lastColumn.resize(cutBits) + 1)

  object State extends SpinalEnum { val Idle, Seek, Step, End = newElement() }
  val state = RegInit(State.Idle)
  val stepIndex = Counter(6, io.step.valid)
  val seeking   = state === State.Seek
  val stepRow   = Bool()

  // What arrives is worked on once, before its edge keeps it.
  val step      = io.step.payload
  val amount    = (step.msb ? -step | step).asUInt.resize(16)
  val slopeSign = RegNextWhen(step.msb, io.step.valid)
  val slopeZero = RegNextWhen(step === 0, io.step.valid)

  /** One edge. It holds the function at the first pixel that it leaves inside, or, once that pixel can only move
    * outwards from row to row, at the last one cut off.
    */
  case class Edge(index: Int) extends Area {
    val slope     = RegNextWhen(amount, io.step.valid && stepIndex === 2 * index) // per pixel towards the inside
    val complete  = io.step.valid && stepIndex === 2 * index + 1
    val descent   = RegNextWhen(step, complete)                                   // per row
    val fromRight = RegNextWhen(slopeSign, complete)
    val flat      = RegNextWhen(slopeZero, complete)
    val outwards  = RegNextWhen(!step.msb && !slopeZero, complete)
    val topLeft   = RegNextWhen(!slopeSign && (!slopeZero || !step.msb && step =/= 0), complete)

    val value = Reg(SInt(28 bits))
    val cut   = Reg(UInt(cutBits bits))
    val back  = Reg(Bool()) // holds the last one cut off

    val more    = !back && value.msb && cut =/= width && !flat
    val less    = back && !value.msb && cut =/= 0
    val turn    = !back && !more && outwards
    val settled = !more && !less && !turn
    val outside = flat && value.msb

    val subtract = !stepRow && !more
    val addend   = (stepRow ? descent | slope.resize(17).asSInt) ^ S(17 bits, default -> subtract)
    when(io.edge.valid && io.edge.index === index) {
      value := edgeValue
      cut := 0
      back := False
    } elsewhen (stepRow || seeking && !settled) {
      value := value + addend + subtract.asUInt.resize(28).asSInt
      when(!stepRow) {
        when(more || less) { cut := more ? (cut + 1) | (cut - 1) }
        back := back || turn
      }
    }
  }

  // Sixteenths are the same at every pixel centre and are dropped: a zero becomes less where the edge does not own it.
  val topLeft = Vec(Bool(), 3)
  val owned   = topLeft(io.edge.index.resized)
  val edgeValue = (io.edge.value >> 4) - (io.edge.value(3 downto 0) === 0 && !owned).asUInt.resize(28).asSInt
  val edges = List.tabulate(3)(Edge(_))
  topLeft.zip(edges).foreach { case (to, edge) => to := edge.topLeft }

  val row   = Reg(UInt(config.tileLog2Height bits))
  val spans = Stream(Span(config))
  def deepest(right: Boolean) =
    edges.map(e => (e.fromRight === Bool(right)) ? e.cut | U(0, cutBits bits)).reduceBalancedTree((a, b) => (a > b) ? a | b)
  val cutLeft  = deepest(right = false)
  val cutRight = deepest(right = true)
  val some     = !edges.map(_.outside).orR && cutLeft +^ cutRight < width
  spans.y := row
  spans.first := cutLeft.resized
  spans.last := (io.lastColumn - cutRight).resized
  spans.end := state === State.End
  spans.valid := state === State.Step && some || state === State.End
  stepRow := state === State.Step && (spans.ready || !some)

  switch(state) {
    is(State.Idle) {
      row := 0
      when(io.start) { state := State.Seek }
    }
    is(State.Seek) { when(edges.map(_.settled).andR) { state := State.Step } }
    is(State.Step) {
      when(stepRow) {
        row := row + 1
        state := (row === io.lastRow) ? State.End | State.Seek
      }
    }
    is(State.End) { when(spans.ready) { state := State.Idle } }
  }
  io.idle := state === State.Idle && !io.up.valid
  spans >-> io.up
}
