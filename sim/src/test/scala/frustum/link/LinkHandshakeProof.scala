package frustum.link

import frustum.harness.{Claims, Formal, Prover}
import frustum.spec.RasterConfig
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.formal._

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
