package frustum.raster.link

import frustum.contract.raster.{Command, RasterConfig}
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
  // For induction: one state at a time, the store is asked only while a unit asks, and a triangle is under way only
  // while its words are offered.
  val reader = unit.reader
  val state = reader.state.pull()
  val triangle = unit.triangles.state.pull()
  assert(CountOne(state.asBits) === 1)
  assert(CountOne(triangle.asBits) === 1)
  assert(!unit.port.asking.pull() || unit.port.ask.pull())
  val ofTriangle = reader.io.opcode.pull() === Command.Triangles.opcode && !reader.isFirst.pull()
  assert(triangle === unit.triangles.State.idle || state === reader.State.offer && ofTriangle)
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
