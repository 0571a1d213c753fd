package frustum.raster.fragment

import frustum.contract.raster.{DepthFunction, RasterConfig, RenderState}
import frustum.harness.{Equality, FlowUnit, FrustumSim, Simulated}
import frustum.model
import frustum.raster.store.RenderStateWord
import frustum.raster.tile.TileSweep
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.util.Random

case class DepthFragment(config: RasterConfig) extends Bundle {
  val at = UInt(config.tileLog2Width + config.tileLog2Height bits)
  val z = UInt(16 bits)
  val tileEnd = Bool()
}

/** The depth test with its memory cleared behind each tile; tells for each fragment whether it passed. */
class DepthTestBench(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(DepthFragment(config)))
    val state = in(RenderStateWord())
    val down = master(Stream(Bool()))
  }
  val unit = DepthStage(config)
  val sweep = TileSweep(config)
  unit.io.clear <> sweep.io.clear
  unit.io.state := io.state
  val ending = RegInit(False) // a mark is on its way to the sweep
  val ready = !sweep.io.clear.all && !(io.up.tileEnd && (ending || !sweep.io.resting))
  FlowUnit(io.up.haltWhen(!ready), io.down, 2) { up =>
    val flow = up.toFlow
    unit.io.up.valid := flow.valid
    val f = unit.io.up.payload
    f.y := flow.at.drop(config.tileLog2Width).asUInt
    f.x := flow.at.take(config.tileLog2Width).asUInt
    f.tileEnd := flow.tileEnd
    for (rest <- Seq(f.r, f.g, f.b, f.a)) rest.assignDontCare()
    unit.io.z := RegNext(flow.z)
    ending := flow.valid && flow.tileEnd
    sweep.io.tileEnd.valid := ending
    sweep.io.tileEnd.payload := RegNext(unit.io.down.bank)
    val result = Flow(Bool())
    result.valid := RegNext(flow.valid) init False
    result.payload := unit.io.passed
    result
  }
}

class DepthStageTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig(19, 21, 3, 3)
  private lazy val unit = FrustumSim.compile("DepthTest")(new DepthTestBench(config))
  private val seed = 4
  private case class Item(at: Int, z: Int, end: Boolean)

  /** Never the same place twice in a row, which the interlock sees to. */
  private def items(r: Random, count: Int): Seq[Item] = {
    val far = Seq.iterate(r.nextInt(64), count)(at => (at + 1 + r.nextInt(63)) & 63)
    val close = Seq.iterate(r.nextInt(3), count)(at => (at + 1 + r.nextInt(2)) % 3)
    def item(at: Int) = Item(
      at,
      if (r.nextBoolean()) r.nextInt(3) + 32767 else Seq(0, 65535, r.nextInt(65536))(r.nextInt(3)),
      end = false
    )
    (close ++ far).map(item).grouped(500).flatMap(_ :+ Item(0, r.nextInt(65536), end = true)).toSeq
  }

  for (function <- 0 to 7; write <- Seq(true, false) if write || function == 1)
    test(s"depth function $function, ${if (write) "written" else "not written"}") {
      val inputs = items(new Random(seed), 1500)
      val state = RenderState(depth = DepthFunction.decode(function), depthWrite = write)
      val depth = new model.raster.fragment.DepthStage(64)
      depth.clear()
      val expected = inputs.map { in =>
        if (in.end) { depth.clear(); true }
        else depth(in.at, in.z, state)
      }
      Equality(unit)(_.io.up, _.io.down)(
        (p: DepthFragment, in: Item) => { p.at #= in.at; p.z #= in.z; p.tileEnd #= in.end },
        (p: Bool) => p.toBoolean
      ).run(
        inputs,
        expected,
        seed,
        minThroughput = Some(0.99),
        setup = dut => StateSim.drive(dut.io.state, state)
      )
    }
}
