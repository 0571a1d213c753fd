package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** Walks three edges with one adder.
  *
  * The edges circulate from the adder, c, to a, b and c again; one that has to slide on goes from a to the adder
  * directly, so that two of them take turns. A settled edge moves down as soon as its end of the row is taken, and may
  * slide in the row below while the others finish theirs.
  *
  * Cycles: 6 from `start` to the first span at the least. A row costs 3; where edges slide, up to 4, one for each step
  * of each edge, and as many again as the edge takes that takes most: two take turns, and the third may have to wait.
  */
final class SerialWalk(config: RasterConfig, io: EdgeWalkerPorts) extends Area {
  val control = new WalkControl(config, io)
  import control.walking
  val fresh, closing = Reg(Bool()) // the row's first edge and its last one are wanted
  val closes = Bool()
  val loadsLast = io.edge.valid && io.edge.index.msb
  val primes = new Area { // the last two edges pass the adder; the first one does as the last is loaded
    val first = RegNext(loadsLast) init False
    val second = RegNext(first) init False
  }
  control.begin(!loadsLast && !primes.first)

  // What finished, a cycle later. Columns of the tile have a sign, as an edge may cut off more than the screen has.
  val done = new Area {
    val fresh, closing, fromRight, cutsAll, stays = Reg(Bool())
    val column = Reg(SInt(config.tileLog2Width + 1 bits))
    val waits = RegInit(False)
    val takes = !(waits && fresh && control.blocked)
  }
  val turn = walking && done.takes || loadsLast || primes.first || primes.second
  val turnValues = turn || io.edge.valid
  val a, b, c = Reg(EdgeState(config))
  val keeps = walking && a.wants // from a to the adder

  /** Goes round: `next` from c, or what is loaded, enters at a. */
  private def ring[T <: Data](turn: Bool, a: T, b: T, c: T, next: T): Unit = when(turn) {
    a := next
    when(!keeps) { b := a }
    c := Mux(keeps, a, b)
  }
  val steps = new Area {
    val a, b, c = Reg(EdgeSteps(config))
    val isY = RegInit(False) toggleWhen io.step.valid
    val zero = io.step.payload === 0
    val next = CombInit(c)
    when(io.step.valid) {
      next.slope := io.step.payload.resized
      next.descent := io.step.payload.resized
      next.flat := zero
      next.grows := !zero && !io.step.payload.msb
    }
    val turnX = turn || io.step.valid && !isY
    val turnY = turn || io.step.valid && isY
    ring(turnX, a.slope, b.slope, c.slope, next.slope)
    ring(turnX, a.flat, b.flat, c.flat, next.flat)
    ring(turnY, a.descent, b.descent, c.descent, next.descent)
    ring(turnY, a.grows, b.grows, c.grows, next.grows)
  }
  val ahead = Vec.fill(3)(Reg(Bool())) // of a, b and c: whether it is in the row below

  // What c does is known as it comes: from a it has to slide; from b it may have to in its first row alone.
  val active = walking || primes.second
  val slides = RegNextWhen(active && (keeps || b.wants), turnValues)
  val shrinks = RegNextWhen(
    active && Mux(
      keeps,
      EdgeMove.shrinks(a, steps.a),
      Mux(b.wants, EdgeMove.shrinks(b, steps.b), !ahead(1) || closes)
    ),
    turnValues
  )
  val finishes = walking && done.takes && shrinks && !slides
  closes := finishes && closing
  val move = new EdgeMove(c, steps.c, slides, shrinks, !walking)
  val moved = EdgeState(config)
  move.moved(moved)
  ring(turnValues, a, b, c, moved)
  when(io.edge.valid) { b.load(io.edge.value) }
  ring(turn, ahead(0), ahead(1), ahead(2), ahead(2) || finishes)

  when(finishes) {
    fresh := closing
    closing := !fresh && !closing
  }

  when(done.takes) {
    done.waits := finishes
    done.fresh := fresh
    done.closing := closing
    done.fromRight := steps.c.fromRight
    done.cutsAll := c.cutsAll
    done.stays := !steps.c.grows
    done.column := steps.c.fromRight ? (control.lastColumn.intoSInt - c.cut.intoSInt) | c.cut.intoSInt
  }
  val taken = walking && done.waits && done.takes

  // The row's span so far, and whether it is known to be empty. Of the row's first edge nothing else counts.
  val first, last = Reg(UInt(config.tileLog2Width bits))
  val firstStays, lastStays = Reg(Bool()) // no later row has more at this end
  val empty = Reg(Bool())
  private def twice(column: SInt, half: Bool) = (column @@ half).asBits.asSInt
  val pastFirst = twice(done.column, done.fromRight) > twice(first.intoSInt, False) // or at it, from the right
  val pastLast = done.column > last.intoSInt
  val crosses = done.fromRight ? (done.fresh ? done.column.msb | !pastFirst) | (!done.fresh && pastLast)
  val otherStays = done.fresh || (done.fromRight ? firstStays | lastStays)
  val lost = crosses || done.cutsAll
  val over = RegNext(taken && done.stays && (crosses && otherStays || done.cutsAll)) init False
  when(taken) {
    empty := lost || empty && !done.fresh
    when(done.fresh || done.fromRight && !pastLast) {
      last := done.fromRight ? done.column.asUInt.resize(config.tileLog2Width) | control.lastColumn
      lastStays := done.stays || !done.fromRight
    }
    when(done.fresh || !done.fromRight && pastFirst) {
      first := done.fromRight ? U(0, config.tileLog2Width bits) | done.column.asUInt.resized
      firstStays := done.stays || done.fromRight
    }
    when(done.fresh) { control.nextRow() }
  }
  when(!walking) {
    fresh := True
    closing := False
  }
  when(!walking || closes) { ahead.foreach(_ := False) }
  control.row(taken && done.closing, filled = !empty && !lost, isLast = control.y === control.lastRow)
  when(over && walking) { control.end() }
  when(!walking) { done.waits := False } // what went on in the row after the last one
  io.up.first := first
  io.up.last := last
}
