package frustum.raster.link

import frustum.contract.raster.RasterConfig
import frustum.harness.{Claims, Formal, Prover}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.formal._
import spinal.lib._

class FramerClaims(drop: Boolean) extends Component {
  val unit = FormalDut(Framer(dropWhenFull = drop))
  assumeInitial(clockDomain.isResetActive)
  Claims.source(unit.io.bytes)
  Claims.sink(unit.io.words)
}

class CommandDecoderClaims extends Component {
  val unit = FormalDut(CommandDecoder(RasterConfig(16, 16, 3, 3)))
  assumeInitial(clockDomain.isResetActive)
  Claims.source(unit.io.words)
  Claims.store(unit.io.store)
  Claims.sink(unit.io.texels)
  Claims.sink(unit.io.job)
  anyseq(unit.io.jobDone)
  assume(!unit.io.jobDone || unit.io.drawing)
  // For induction: one state at a time, the store is asked in five of them, and for a vertex's word when it was checked.
  import DecoderState._
  val state = unit.state.pull()
  val asking = unit.asking.pull()
  assert(CountOne(state.asBits) === 1)
  assert(!asking || Seq(writeState, writeVertex, read, writeIndices, writeBox).map(state === _).orR)
  assert(!asking || state =/= writeVertex || !unit.check.io.busy.pull())
}

/** What the link's units offer stays until it is taken, unchanged. */
class LinkHandshakeProof extends AnyFunSuite {
  test("words of the framer", Formal) {
    for (drop <- Seq(true, false)) Prover.prove(s"Framer_$drop", depth = 4)(new FramerClaims(drop))
  }

  test("store, texels and jobs of the decoder", Formal) {
    Prover.prove("CommandDecoder", depth = 8)(new CommandDecoderClaims)
  }
}
