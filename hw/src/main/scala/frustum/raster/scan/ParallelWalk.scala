package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** Walks three edges with an adder for each.
  *
  * Once all are settled they go on to the row below; meanwhile the row's ends are taken from what they cut off.
  *
  * Cycles: 5 from `start` to the first row's span; per row 2, and one for each lateral step of the edge that takes
  * most.
  */
final class ParallelWalk(config: RasterConfig, io: EdgeWalkerPorts) extends Area {
  val control = new WalkControl(config, io)
  import control.walking
  val loadsLast = io.edge.valid && io.edge.index === 2
  val primes = RegNext(loadsLast) init False
  control.begin(!loadsLast)

  val isY = RegInit(False) toggleWhen io.step.valid
  val steps = Seq.fill(3)(Reg(EdgeSteps(config)))
  // The steps move up: the first edge's are in place with the last one's.
  for ((s, below) <- steps.zip(steps.tail.map(Some(_)) :+ None)) {
    val step = io.step.payload.resize(config.ranges.stepBits)
    val zero = io.step.payload === 0
    when(io.step.valid && !isY) {
      s.slope := below.fold(step)(_.slope)
      s.flat := below.fold(zero)(_.flat)
    }
    when(io.step.valid && isY) {
      s.descent := below.fold(step)(_.descent)
      s.grows := below.fold(!zero && !step.msb)(_.grows)
    }
  }

  val down = RegInit(False) // all have settled: the rows' ends are taken, and the edges move down
  val edges = for ((s, n) <- steps.zipWithIndex) yield new Area {
    val state = Reg(EdgeState(config))
    // Signs are late: what is not wanted is worked out all the same, and not taken.
    val move = new EdgeMove(state, s, walking && !down, down || walking && EdgeMove.shrinks(state, s), !walking)
    val lost = state.cutsAll && !state.canEnter // and with it the row
    when(walking && state.wants || down || primes) { move.moved(state) }
    when(io.edge.valid && io.edge.index === n) { state.load(io.edge.value) }
    val fromLeft = s.fromRight ? U(0, config.tileLog2Width bits) | state.cut
    val fromRight = s.fromRight ? state.cut | U(0, config.tileLog2Width bits)
  }
  val lost = edges.map(_.lost).orR
  val settled = lost || !edges.map(_.state.wants).orR

  /** The most that edges cut off at an end, and whether no later row will have more there. */
  case class End() extends Bundle {
    val cut = UInt(config.tileLog2Width bits)
    val stays = Bool()
    def max(other: End): End = (other.cut > cut) ? other | this
  }
  private def end(cut: UInt, stays: Bool) = { val e = End(); e.cut := cut; e.stays := stays; e }
  val ends = edges.zip(steps).map { case (e, s) =>
    (end(e.fromLeft, s.fromRight || !s.grows), end(e.fromRight, !s.fromRight || !s.grows))
  }
  // Two of the edges have stood still for a cycle when the row ends.
  val twoLeft = RegNext(ends(0)._1.max(ends(1)._1))
  val twoRight = RegNext(ends(0)._2.max(ends(1)._2))
  val row = new Area {
    val waits = RegInit(False)
    val left = RegNextWhen(twoLeft.max(ends(2)._1), down)
    val right = RegNextWhen(twoRight.max(ends(2)._2), down)
    val none = RegNextWhen(edges.map(_.state.cutsAll).orR, down)
    val forever = RegNextWhen(edges.zip(steps).map { case (e, s) => e.lost && !s.grows }.orR, down)
    val leaves = waits && !control.blocked
    val last = control.lastColumn.intoSInt - right.cut.intoSInt
    val crosses = left.cut.intoSInt > last
    when(leaves) { waits := False }
    when(down) { waits := True }
  }
  down := walking && settled && !down && !(row.waits && control.blocked)
  control.row(
    row.leaves,
    filled = !row.none && !row.crosses,
    isLast = control.y + 1 === control.lastRow || row.forever || row.crosses && row.left.stays && row.right.stays
  )
  when(row.leaves) { control.nextRow() }
  when(!walking) { // what the edges did since the last row is of no more use
    down := False
    row.waits := False
  }
  io.up.first := RegNextWhen(row.left.cut, row.leaves)
  io.up.last := RegNextWhen(row.last.asUInt.resize(config.tileLog2Width), row.leaves)
}
