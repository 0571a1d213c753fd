package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.harness.{Claims, Formal, Prover}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.formal._

/** Any fragments, any resolver that tells the end of what it has been given. */
class InterlockClaims(config: RasterConfig) extends Component {
  val unit = FormalDut(Interlock(config))
  assumeInitial(clockDomain.isResetActive)
  Claims.source(unit.io.up)
  anyconst(unit.io.state)
  anyseq(unit.io.clear)
  val watch = new InterlockWatch(unit.io.down, unit.io.state.blend, unit.io.clear.done)
  assume(!unit.io.clear.all)
  assume(!unit.io.clear.done || watch.resolving)
  assert(!watch.tooClose)
  assert(!watch.tooEarly)
  assert(unit.resolves.pull() === watch.resolving)
}

class InterlockProof extends AnyFunSuite {
  test("fragments of a pixel keep apart, and tiles end one after the other", Formal) {
    Prover.prove("Interlock", depth = 6)(new InterlockClaims(RasterConfig(41, 27, 4, 3)))
  }
}
