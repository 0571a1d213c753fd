package frustum.raster.fragment

import frustum.contract.raster.{RasterConfig, RenderState}
import frustum.harness.{Equality, FlowUnit, FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.util.Random

class AlphaTestBench(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(ColoredFragment(config)))
    val state = in(frustum.raster.store.RenderStateWord())
    val down = master(Stream(ColoredFragment(config)))
  }
  FlowUnit(io.up, io.down, 2) { up =>
    val unit = AlphaStage(config)
    unit.io.up << up.toFlow
    unit.io.state := io.state
    unit.io.down
  }
}

class AlphaStageTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig()
  private lazy val unit = FrustumSim.compile("AlphaTest")(new AlphaTestBench(config))

  for (reference <- Seq(0, 1, 16, 31))
    test(s"drops what is below $reference, and no mark") {
      val random = new Random(1)
      val corners = for (a <- 0 to 31; end <- Seq(false, true)) yield (random.nextInt(1 << 24), a, end)
      val inputs =
        corners ++ Seq.fill(1000)((random.nextInt(1 << 24), random.nextInt(32), random.nextInt(20) == 0))
      Equality(unit)(_.io.up, _.io.down)(
        (p: ColoredFragment, in: (Int, Int, Boolean)) => {
          AlphaStageTest.rest(p, in._1); p.a #= in._2; p.tileEnd #= in._3
        },
        (p: ColoredFragment) => (AlphaStageTest.rest(p), p.a.toInt, p.tileEnd.toBoolean)
      ).run(
        inputs,
        inputs.filter { case (_, a, end) => end || a >= reference },
        seed = 1,
        minThroughput = Some(0.99),
        setup = dut => StateSim.drive(dut.io.state, RenderState(alphaRef = reference))
      )
    }
}

object AlphaStageTest {

  /** Place and colour as 24 bits, for tiles of 16 x 16. */
  def rest(p: ColoredFragment, bits: Int): Unit = {
    p.x #= bits & 15; p.y #= (bits >> 4) & 15
    p.r #= (bits >> 8) & 31; p.g #= (bits >> 13) & 63; p.b #= (bits >> 19) & 31
  }
  def rest(p: ColoredFragment): Int =
    p.x.toInt | p.y.toInt << 4 | p.r.toInt << 8 | p.g.toInt << 13 | p.b.toInt << 19
}
