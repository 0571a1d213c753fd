package frustum.arithmetic

import frustum.harness.{Equality, FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._
import spinal.lib.misc.pipeline._

import scala.util.Random

/** A table look-up with a single enable amid `stages` stages, beside a sum that goes from stage to stage. */
class LockstepBench(stages: Int) extends Component {
  val io = new Bundle {
    val up = slave(Stream(UInt(8 bits)))
    val down = master(Stream(UInt(16 bits)))
    val busy = out Bool ()
  }
  val line = new LockstepPipeline(stages)
  val SUM, SQUARE = Payload(UInt(16 bits))
  val squares = Mem(UInt(16 bits), (0 to 255).map(n => U(n * n, 16 bits)))
  line(0).driveFrom(io.up)((_, _) => ())
  line(0)(SUM) := io.up.payload.resized
  line(1)(SQUARE) := squares.readSync(io.up.payload, line.enable)
  line.nodes.last.driveTo(io.down)((to, node) => to := node(SUM) + node(SQUARE))
  io.busy := line.anyValid
  line.build()
}

/** The shortest pipeline behind a longer one. */
class LockstepPair extends Component {
  val io = new Bundle {
    val up = slave(Stream(UInt(8 bits)))
    val down = master(Stream(UInt(16 bits)))
    val busy = out Bool ()
  }
  val long = new LockstepBench(5)
  val short = new LockstepBench(1)
  long.io.up << io.up
  short.io.up << long.io.down.translateWith(long.io.down.payload(7 downto 0))
  io.down << short.io.down
  io.busy := long.io.busy || short.io.busy
}

class LockstepPipelineTest extends AnyFunSuite with Simulated {
  private def once(n: Int) = n + n * n & 0xffff

  test("memories stay in step with their pipelines") {
    val random = new Random(1)
    val inputs = (0 to 255) ++ Seq.fill(2000)(random.nextInt(256))
    Equality(FrustumSim.compile("LockstepPipeline")(new LockstepPair))(_.io.up, _.io.down)(
      (p: UInt, v: Int) => p #= v,
      (p: UInt) => p.toInt
    ).run(
      inputs,
      inputs.map(n => once(once(n) & 255)),
      seed = 1,
      minThroughput = Some(0.99),
      done = dut => assert(!dut.io.busy.toBoolean, "busy when everything has left")
    )
  }
}
