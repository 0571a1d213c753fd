package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** Pixels `first` to `last` of row `y` of the tile, inclusive; or, with `end`, no pixels and no more of the triangle.
  */
case class Span(config: RasterConfig) extends Bundle {
  val y = UInt(config.tileLog2Height bits)
  val first, last = UInt(config.tileLog2Width bits)
  val end = Bool()
}

/** Finds the pixels of a triangle in a tile: from the top row down, each row's span, then the end marker.
  *
  * Each of the three edge functions keeps the outermost pixel of the row that it lets through (the leftmost where the
  * function grows to the right), stepping inwards or outwards from the row above. The edges share one adder in turn.
  * Top-left rule (Pineda 1988, with integer edge functions at pixel centres): an exact zero is inside for a top or left
  * edge alone.
  *
  * Clocks: 4 before the first row; per row 4, and 3 for each lateral step of the edge that takes most (up to 2 fewer,
  * as the row ends with its last edge); while `up` is not ready the span is held.
  *
  * To load, while `idle`: per edge its steps per 1/16 pixel (x then y, edge after edge, never both 0) and, edge after
  * edge too, each after its steps, its function in the top row, at the left column or, where the x step is negative, at
  * `lastColumn`, in 1/256 pixel^2; then `start`, with which `lastColumn` and `lastRow` are taken.
  */
case class EdgeWalker(config: RasterConfig) extends Component {
  val io = new Bundle {
    val lastColumn = in UInt (config.tileLog2Width bits) // of the pixels of the tile that are on the screen
    val lastRow = in UInt (config.tileLog2Height bits)
    val step = slave(Flow(SInt(17 bits)))
    val edge = slave(Flow(new Bundle { val index = UInt(2 bits); val value = SInt(32 bits) }))
    val start = in Bool ()
    val idle = out Bool ()
    val up = master(Stream(Span(config)))
  }

  object State extends SpinalEnum { val Idle, Prime, Seek, Show, End = newElement() }
  val state = RegInit(State.Idle)
  val priming = state === State.Prime
  val seeking = state === State.Seek
  val turning = priming || seeking
  val loading = io.edge.valid
  val stepIsY = RegInit(False) toggleWhen io.step.valid
  val lastColumn = RegNextWhen(io.lastColumn, io.start)
  val lastRow = RegNextWhen(io.lastRow, io.start)
  val row = Reg(UInt(config.tileLog2Height bits))

  /** State of the edges that circulates: from place a over b and c to a again. */
  case class Ring[T <: Data](kind: HardType[T], turn: Bool) extends Area {
    val a, b, c = Reg(kind())
    when(turn) { a := c; b := a; c := b }
  }
  // Steps enter at b and values at c; `start` moves the steps on to where their values are.
  private val stepBits = config.ranges.stepBits
  val slope = Ring(SInt(stepBits bits), turning || io.start || io.step.valid && !stepIsY) // per pixel to the right
  val descent = Ring(SInt(stepBits bits), turning || io.start || io.step.valid && stepIsY) // per row
  when(io.step.valid) {
    when(!stepIsY) { slope.b := io.step.payload.resized } otherwise { descent.b := io.step.payload.resized }
  }
  val turn = turning || loading
  val value =
    Ring(SInt(config.ranges.edgeBits bits), turn) // at the pixel of `position`, or, if `back`, at the one outside of it
  val position = Ring(UInt(config.tileLog2Width bits), turn)
  val back = Ring(Bool(), turn) // not yet primed: the value's sixteenths are zero
  val parity = Ring(Bool(), turn) // parity of the row that the edge works on
  when(loading) {
    value.c := (io.edge.value >> 4).resized
    position.c := 0
    back.c := io.edge.value(3 downto 0) === 0
    parity.c := False
  }

  // Between b and c: whether the edge can move no further. A flat one never moves.
  val isFlat = slope.b === 0
  val atEnd = Mux(slope.b.msb ^ back.b, position.b === 0, position.b.andR)
  val flat = RegNextWhen(isFlat, slope.turn)
  val stop = RegNextWhen(isFlat || atEnd, turn)

  // Between c and a: what to do. An edge moves inwards where its value is negative. Once it is inside and can only move
  // outwards from row to row, it tests the pixel outside of its own, and moves outwards where that is not negative.
  val fromRight = slope.c.msb
  val negative = value.c.msb
  val move = Mux(negative ^ back.c, !stop, !back.c && !negative && !descent.c.msb)
  val mine = seeking && parity.c === row.lsb
  val moves = mine && move
  val finishes = mine && !move
  val add = mine && (!move || negative ^ fromRight) // slope or descent; otherwise subtract slope or nothing
  val shifts = moves && (negative || back.c)
  val topLeft = !fromRight && (!flat || !descent.c.msb)

  // Sixteenths are the same at every pixel centre and are dropped: a zero becomes negative where it is outside of the
  // edge.
  val addend = RegNextWhen(
    Mux(moves, slope.c ^ S(stepBits bits, default -> !add), descent.c | S(stepBits bits, default -> !add)),
    turn
  )
  val carry = RegNextWhen(!add && !(priming && back.c && !topLeft), turn)
  val primer = Mux(priming && fromRight, lastColumn, U(lastColumn.range -> (shifts && !add)))
  when(turn) {
    position.a := ((position.c @@ True) + (primer @@ (shifts && add))) >> 1
    back.a := back.c && !priming || moves && !negative
    parity.a := parity.c ^ finishes
    value.b := ((value.a ## True).asSInt + (addend ## carry).asSInt) >> 1
  }

  // The edges' innermost positions in the row.
  val shown = False
  val clear = priming || shown
  val first, last = Reg(UInt(config.tileLog2Width bits))
  val none = Reg(Bool()) // no pixel is left
  val inner = (position.c > Mux(fromRight, last, first)) ^ fromRight
  val beyond = Mux(fromRight, position.c < first, position.c > last)
  when(clear) {
    first := 0
    last := lastColumn
    none := False
  } elsewhen (finishes) {
    when(inner && !fromRight) { first := position.c }
    when(inner && fromRight) { last := position.c }
    when(negative && !back.c || beyond) { none := True }
  }
  io.up.y := row
  io.up.first := first
  io.up.last := last
  io.up.end := state === State.End
  io.up.valid := state === State.Show && !none || state === State.End
  io.idle := state === State.Idle

  switch(state) {
    is(State.Idle) {
      row := U(row.range -> true) - 2 // the three edges are primed in what would be the three rows above
      when(io.start) { state := State.Prime }
    }
    is(State.Prime) {
      row := row + 1
      when(row.andR) { state := State.Seek }
    }
    is(State.Seek) {
      when(finishes && parity.a =/= row.lsb && parity.b =/= row.lsb) { state := State.Show }
    }
    is(State.Show) {
      when(io.up.ready || none) {
        shown := True
        row := row + 1
        state := Mux(row === lastRow, State.End, State.Seek)
      }
    }
    is(State.End) { when(io.up.ready) { state := State.Idle } }
  }
}
