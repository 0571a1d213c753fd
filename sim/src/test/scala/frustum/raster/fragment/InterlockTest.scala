package frustum.raster.fragment

import frustum.contract.raster.{RasterConfig, RenderState}
import frustum.harness.{Equality, FlowUnit, FrustumSim, Simulated, Stalls}
import frustum.raster.store.RenderStateWord
import frustum.raster.tile.TileClear
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.util.Random

/** The interlock with a resolver that takes its time, and watchmen that count what must never happen. */
class InterlockBench(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(ColoredFragment(config)))
    val state = in(RenderStateWord())
    val resolve = in UInt (8 bits) // clocks from a tile's end to `done`
    val down = master(Stream(ColoredFragment(config)))
    val tooClose, tooEarly = out(Reg(UInt(16 bits)) init 0)
  }
  FlowUnit(io.up, io.down, 3) { up =>
    val unit = Interlock(config)
    unit.io.up << up
    unit.io.state := io.state
    val out = unit.io.down

    val timer = Reg(UInt(8 bits)) init 0
    val done = timer === 1
    when(timer =/= 0) { timer := timer - 1 }
    when(out.valid && out.tileEnd) { timer := io.resolve }
    unit.io.clear.assignDontCare()
    unit.io.clear.all := False
    unit.io.clear.active := timer =/= 0
    unit.io.clear.done := done

    val watch = new InterlockWatch(out, io.state.blend, done)
    when(watch.tooClose) { io.tooClose := io.tooClose + 1 }
    when(watch.tooEarly) { io.tooEarly := io.tooEarly + 1 }
    out
  }
}

class InterlockTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig()
  private lazy val unit = FrustumSim.compile("Interlock")(new InterlockBench(config))
  private val seed = 3

  /** `bits` as [[AlphaStageTest.rest]] has them, the place in the lowest eight. */
  private case class Item(bits: Int, end: Boolean)
  private def item(r: Random, x: Int, y: Int) = Item(r.nextInt(1 << 16) << 8 | y << 4 | x, end = false)

  private def check(
      items: Seq[Item],
      blend: Boolean,
      throughput: Double,
      resolve: Int = 40,
      stalls: Seq[Stalls] = Stalls.All
  ): Unit =
    Equality(unit)(_.io.up, _.io.down)(
      (p: ColoredFragment, in: Item) => { AlphaStageTest.rest(p, in.bits); p.a #= 7; p.tileEnd #= in.end },
      (p: ColoredFragment) => Item(AlphaStageTest.rest(p), p.tileEnd.toBoolean)
    ).run(
      items,
      items,
      seed,
      stalls,
      Some(throughput),
      setup = dut => { StateSim.drive(dut.io.state, RenderState(blend = blend)); dut.io.resolve #= resolve },
      done = dut => {
        assert(dut.io.tooClose.toInt == 0, s"seed $seed: fragments of a pixel too close together")
        assert(dut.io.tooEarly.toInt == 0, s"seed $seed: a tile ended before the last was resolved")
      }
    )

  for (blend <- Seq(false, true)) {
    val how = if (blend) "blended" else "replaced"
    test(s"the same pixel again and again, $how") {
      val r = new Random(seed)
      check(Seq.fill(1500)(item(r, 5, 9)), blend, if (blend) 0.332 else 0.498)
    }
    test(s"a few pixels and ends of tiles, $how") {
      val r = new Random(seed)
      val hammer = Seq.fill(3000)(if (r.nextInt(8) == 0) Item(r.nextInt(1 << 24), end = true)
      else item(r, r.nextInt(3), r.nextInt(2)))
      for (resolve <- Seq(3, 40)) check(hammer, blend, 0.02, resolve)
    }
    test(s"neighbours in a row never wait, $how") {
      val r = new Random(seed)
      val rows = Seq.tabulate(2000)(n => item(r, n % 16, n / 16 % 16))
      check(rows, blend, 0.995)
      check(rows.reverse, blend, 0.995, stalls = Seq(Stalls.Never))
    }
  }
}
