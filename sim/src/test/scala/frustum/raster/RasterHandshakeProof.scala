package frustum.raster

import frustum.contract.raster.{RasterConfig, WalkerKind}
import frustum.harness.{Claims, Formal, Prover}
import frustum.raster.scan.{EdgeWalker, Interpolator, ParallelWalk, SerialWalk, TileSequencer, WalkControl}
import frustum.raster.setup.SetupFetch
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.formal._
import spinal.lib._

class TileSequencerClaims(config: RasterConfig) extends Component {
  val unit = FormalDut(TileSequencer(config))
  assumeInitial(clockDomain.isResetActive)
  Claims.source(unit.io.frame)
  Claims.store(unit.io.store, steady = false) // a box that is no longer wanted is not asked for again
  Claims.sink(unit.io.tile)
  Claims.sink(unit.io.job)
  anyseq(unit.io.drained)
  assert(
    unit.io.frame.valid || unit.state.pull() === unit.State.Idle
  ) // so that induction starts amid a frame
}

class EdgeWalkerClaims(config: RasterConfig) extends Component {
  val unit = FormalDut(EdgeWalker(config))
  assumeInitial(clockDomain.isResetActive)
  Seq(
    unit.io.step,
    unit.io.edge,
    unit.io.start,
    unit.io.lastColumn,
    unit.io.firstRow,
    unit.io.lastRow
  ).foreach(anyseq(_))
  when(!unit.io.idle) { assume(!unit.io.step.valid && !unit.io.edge.valid && !unit.io.start) }
  Claims.sink(unit.io.up)

  // For induction: what a walk's registers hold together.
  def control(c: WalkControl): Unit = {
    val Seq(asked, walking, ending, shown) = Seq(c.asked, c.walking, c.ending, c.shown).map(_.pull())
    assert(!shown || walking || ending)
    assert(!asked || !walking && !ending && !shown)
    assert(!walking || !ending)
  }
  unit.walk match {
    case w: SerialWalk =>
      control(w.control)
      val Seq(walking, fresh, closing) = Seq(w.control.walking, w.fresh, w.closing).map(_.pull())
      val Seq(waits, first, last) = Seq(w.done.waits, w.done.fresh, w.done.closing).map(_.pull())
      // A row's three edges finish one after the other; a span is offered before the next row's first edge counts.
      when(walking) {
        assert(!(fresh && closing))
        when(waits) { assert(!(first && last) && fresh === last && closing === (!first && !last)) }
        when(w.control.shown.pull()) { assert(Mux(waits, first, fresh)) }
      }
    case w: ParallelWalk =>
      control(w.control)
      val (down, waits) = (w.down.pull(), w.row.waits.pull())
      assert(!(down && waits))
      assert(!waits || w.control.walking.pull())
  }
}

class InterpolatorClaims(config: RasterConfig) extends Component {
  val unit = FormalDut(Interpolator(config.copy(slots = 3)))
  assumeInitial(clockDomain.isResetActive)
  Claims.source(unit.io.token)
  Claims.source(unit.io.spans)
  anyseq(unit.io.write)
  Claims.sink(unit.io.down)
}

class SetupFetchClaims(config: RasterConfig) extends Component {
  val unit = FormalDut(SetupFetch(config, 3))
  assumeInitial(clockDomain.isResetActive)
  Seq(
    unit.io.start,
    unit.io.program,
    unit.io.values,
    unit.io.readData,
    unit.io.spare.address,
    unit.io.spare.write
  ).foreach(anyseq(_))
  // the triangle stays while it is fetched
  anyconst(unit.io.triangle)
  anyconst(unit.io.bank)
  assume(!unit.io.start || unit.io.idle)
  Claims.store(unit.io.store)
  // For induction: requests are made in three states alone, and none while an answer comes.
  val asking = unit.asking.pull() || past(unit.ask.pull()) && pastValid
  val asks = Seq(unit.State.Vertices, unit.State.Exponents, unit.State.Read).map(unit.state.pull() === _).orR
  assert(!asking || asks)
  assert(!asking || !unit.io.store.rsp.valid)
}

/** What the rasterizer's units offer stays until it is taken, unchanged. */
class RasterHandshakeProof extends AnyFunSuite {
  private val config = RasterConfig(41, 27, 3, 3)

  test("tiles and jobs of the sequencer", Formal) {
    Prover.prove("TileSequencer", depth = 4)(new TileSequencerClaims(config))
  }

  for (kind <- Seq(WalkerKind.Serial, WalkerKind.Parallel)) test(s"spans of the edge walker, $kind", Formal) {
    Prover.prove(s"EdgeWalker$kind", depth = 4)(new EdgeWalkerClaims(config.copy(walker = kind)))
  }

  test("fragments of the interpolator", Formal) {
    Prover.prove("Interpolator", depth = 3)(new InterpolatorClaims(config))
  }

  test("requests of the set-up's fetch", Formal) {
    Prover.prove("SetupFetch", depth = 4)(new SetupFetchClaims(config))
  }
}
