package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._

/** Walks three edges with one adder.
  *
  * The edges circulate. The one at the adder moves along the row until it is settled; then it goes on to the row below
  * as it makes room for the next.
  *
  * Cycles: 4 from `start` to the first row's span; per row 3, and one for each lateral step of each edge.
  */
final class SerialWalk(config: RasterConfig, io: EdgeWalkerPorts) extends Area {
  val control = new WalkControl(config, io)
  import control.walking
  val fresh, closing = Reg(Bool()) // the row's first edge and its last one are at the adder
  val loadsLast = io.edge.valid && io.edge.index.msb
  val primes = new Area { // the last two edges pass the adder; the first one does as the last is loaded
    val first = RegNext(loadsLast) init False
    val second = RegNext(first) init False
  }
  control.begin(!loadsLast && !primes.first)

  // Steps enter at a; values at b, so that the adder is before a alone.
  val slides, descends = Bool()
  val turn = descends || io.edge.valid || primes.first || primes.second
  val steps = new Area {
    val a, b, c = Reg(EdgeSteps(config))
    val isY = RegInit(False) toggleWhen io.step.valid
    val turn = descends || loadsLast || primes.first || primes.second
    val zero = io.step.payload === 0
    val step = io.step.payload.resize(config.ranges.stepBits)
    when(turn || io.step.valid && !isY) {
      b.slope := a.slope
      c.slope := b.slope
      a.slope := io.step.valid ? step | c.slope
      b.flat := a.flat
      c.flat := b.flat
      a.flat := io.step.valid ? zero | c.flat
    }
    when(turn || io.step.valid && isY) {
      b.descent := a.descent
      c.descent := b.descent
      a.descent := io.step.valid ? step | c.descent
      b.grows := a.grows
      c.grows := b.grows
      a.grows := io.step.valid ? (!zero && !step.msb) | c.grows
    }
  }
  val a, b, c = Reg(EdgeState(config))
  val edge = steps.c
  val move = new EdgeMove(c, edge, slides, prime = !walking)
  when(turn) {
    move.descended(a)
    b := a
    c := b
  }
  when(io.edge.valid) { b.load(io.edge.value) }
  when(slides) { move.slid(c) }

  // The row's span so far, and whether it is known to be empty. Of the row's first edge nothing else counts.
  val first, last = Reg(UInt(config.tileLog2Width bits))
  val firstStays, lastStays = Reg(Bool()) // no later row has more at this end
  val empty = Reg(Bool())
  val fromEnd = control.lastColumn.intoSInt - c.cut.intoSInt
  val place = edge.fromRight ? fromEnd | c.cut.intoSInt
  val pastFirst = (place @@ edge.fromRight).asBits.asSInt > (first.intoSInt @@ False).asBits.asSInt // or at it, from the right
  val pastLast = place > last.intoSInt
  val crosses = edge.fromRight ? (fresh ? fromEnd.msb | !pastFirst) | (!fresh && pastLast)
  val stays = !edge.grows
  val otherStays = fresh || (edge.fromRight ? firstStays | lastStays)
  val lost = crosses || c.cutsAll
  val over = stays && (crosses && otherStays || c.cutsAll && !c.canEnter)

  val settled = empty || !(c.inside ? c.canLeave | c.canEnter)
  slides := walking && !settled
  descends := walking && settled && !(fresh && control.blocked)
  when(slides && crosses && c.cutsAll) { empty := True }
  when(descends) {
    fresh := closing
    closing := !fresh && !closing
    empty := !closing && (lost || empty)
    when(edge.fromRight) {
      when(fresh) { first := 0; firstStays := True }
      when(fresh || !pastLast) { last := fromEnd.asUInt.resized; lastStays := stays }
    } otherwise {
      when(fresh) { last := control.lastColumn; lastStays := True }
      when(fresh || pastFirst) { first := c.cut; firstStays := stays }
    }
    when(fresh) { control.nextRow() }
  }
  when(io.start) { fresh := True; closing := False; empty := False }
  control.row(
    descends && (closing || over),
    filled = !empty && !lost,
    isLast = over || control.y === control.lastRow
  )
  io.up.first := first
  io.up.last := last
}
