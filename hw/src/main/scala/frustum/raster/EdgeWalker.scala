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

/** The window of a tile in which a triangle may lie, tile coordinates, inclusive. */
case class Window(config: RasterConfig) extends Bundle {
  val left, right = UInt(config.tileLog2Width bits)
  val top, bottom = UInt(config.tileLog2Height bits)
}

/** Finds the pixels of a triangle in a window: from the top row down, each row's span, then the end mark.
  *
  * Each of the three edge functions tracks how many pixels it cuts off its side of the row (left where the function grows
  * to the right), stepping inwards or outwards from the row above, all three at once. So a row costs two clocks and the
  * largest lateral move of an edge, and is found while the row before is being drawn. Top-left rule (Pineda 1988, with
  * integer edge functions at pixel centres): an exact zero is inside for a top or left edge alone.
  *
  * To load: `window`, then per edge `edge` (function at the window's starting end, 1/256 pixel^2) and its steps per
  * 1/16 pixel (x then y, edge after edge, by `step`); then `start`. All while `idle`.
  */
case class EdgeWalker(config: RasterConfig) extends Component {
  val io = new Bundle {
    val window = in(Window(config))
    val step   = slave Flow (SInt(17 bits))
    val edge   = slave Flow (new Bundle { val index = UInt(2 bits); val value = SInt(32 bits) })
    val start  = in Bool ()
    val idle   = out Bool ()
    val up     = master Stream (Span(config))
  }

  val cutBits = config.tileLog2Width + 1
  val width   = RegNext((io.window.right - io.window.left).resize(cutBits) + 1)

  object State extends SpinalEnum { val Idle, Seek, Step, End = newElement() }
  val state = RegInit(State.Idle)
  val stepIndex = Counter(6, io.step.valid)
  val seeking   = state === State.Seek
  val stepRow   = Bool()

  /** One edge. It holds the function at the first pixel that it leaves inside, or, once that pixel can only move
    * outwards from row to row, at the last one cut off.
    */
  case class Edge(index: Int) extends Area {
    val slope, descent = Reg(SInt(17 bits))
    when(io.step.valid && stepIndex === 2 * index) { slope := io.step.payload }
    when(io.step.valid && stepIndex === 2 * index + 1) { descent := io.step.payload }
    val fromRight = slope.msb
    val flat      = slope === 0
    val topLeft   = !fromRight && (!flat || !descent.msb && descent =/= 0)
    val outwards  = !descent.msb && !flat

    object Mode extends SpinalEnum { val Zero, Inwards, Outwards = newElement() }
    val mode     = Reg(Mode())
    val value    = Reg(SInt(28 bits))
    val cut      = Reg(UInt(cutBits bits))
    val onBorder = Reg(Bool()) // the sixteenths, the same at every pixel centre, are zero
    when(io.edge.valid && io.edge.index === index) {
      value := io.edge.value >> 4
      onBorder := io.edge.value(3 downto 0) === 0
      cut := 0
      mode := Mode.Zero
    }

    val more    = mode === Mode.Inwards && value.msb && cut =/= width && !flat
    val less    = mode === Mode.Outwards && !value.msb && cut =/= 0
    val turn    = mode === Mode.Inwards && !more && outwards
    val settled = mode =/= Mode.Zero && !more && !less && !turn
    val outside = flat && value.msb

    val forwards = more ^ fromRight // towards growing x, or back by as much
    val addend   = SInt(17 bits)
    addend := forwards ? slope | -slope
    when(mode === Mode.Zero) { addend := -(onBorder && !topLeft).asUInt.resize(17).asSInt }
    when(stepRow) { addend := descent }
    when(stepRow || seeking && !settled) { value := value + addend }
    when(seeking) {
      when(mode === Mode.Zero) { mode := Mode.Inwards }
      when(turn) { mode := Mode.Outwards }
      when(more) { cut := cut + 1 }
      when(less) { cut := cut - 1 }
    }
  }
  val edges = List.tabulate(3)(Edge(_))

  val row   = Reg(UInt(config.tileLog2Height bits))
  val spans = Stream(Span(config))
  def deepest(right: Boolean) =
    edges.map(e => (e.fromRight === Bool(right)) ? e.cut | U(0, cutBits bits)).reduceBalancedTree((a, b) => (a > b) ? a | b)
  val cutLeft  = deepest(right = false)
  val cutRight = deepest(right = true)
  val some     = !edges.map(_.outside).orR && cutLeft +^ cutRight < width
  spans.y := row
  spans.first := (io.window.left + cutLeft).resized
  spans.last := (io.window.right - cutRight).resized
  spans.end := state === State.End
  spans.valid := state === State.Step && some || state === State.End
  stepRow := state === State.Step && (spans.ready || !some)

  switch(state) {
    is(State.Idle) {
      row := io.window.top
      when(io.start) { state := State.Seek }
    }
    is(State.Seek) { when(edges.map(_.settled).andR) { state := State.Step } }
    is(State.Step) {
      when(stepRow) {
        row := row + 1
        state := (row === io.window.bottom) ? State.End | State.Seek
      }
    }
    is(State.End) { when(spans.ready) { state := State.Idle } }
  }
  io.idle := state === State.Idle && !io.up.valid
  spans >-> io.up
}
