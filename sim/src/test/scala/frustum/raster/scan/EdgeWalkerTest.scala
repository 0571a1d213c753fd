package frustum.raster.scan

import frustum.contract.raster.{RasterConfig, WalkerKind}
import frustum.harness.{FrustumSim, Simulated}
import frustum.mutation.{EdgeJob, EdgeJobs}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.sim._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

class EdgeWalkerTest extends AnyFunSuite with Simulated {
  private val seed = 11

  private final class Unit(val config: RasterConfig) {
    private val name = s"EdgeWalker${config.walker}${config.tileWidth}x${config.tileHeight}"
    private val r = new Random(seed)
    val jobs = new EdgeJobs(config, r)
    private lazy val walker = FrustumSim.compile(name)(EdgeWalker(config))

    /** Walks triangles one after the other; gives the cycles of each, from the one after `start` until it is idle. */
    def walk(jobs: Seq[EdgeJob], stalled: Boolean): Seq[Int] = {
      val cycles = ArrayBuffer.empty[Int]
      walker.doSim(s"${name}_$seed", seed) { dut =>
        val got = ArrayBuffer.empty[String]
        dut.io.step.valid #= false
        dut.io.edge.valid #= false
        dut.io.start #= false
        StreamMonitor(dut.io.up, dut.clockDomain) { s =>
          got += (if (s.end.toBoolean) "end" else s"${s.y.toInt}: ${s.first.toInt}..${s.last.toInt}")
        }
        val ready = if (stalled) Some(StreamReadyRandomizer(dut.io.up, dut.clockDomain)) else None
        if (!stalled) dut.io.up.ready #= true
        dut.clockDomain.forkStimulus(10)
        dut.clockDomain.waitSampling(5)
        for ((job, n) <- jobs.zipWithIndex) {
          ready.foreach(_.setFactor(if (n % 2 == 0) 2f else 0.3f))
          got.clear()
          load(dut, job)
          cycles += untilIdle(dut)
          assert(got == job.spans.map(s => s"${s.y}: ${s.first}..${s.last}") :+ "end", s"seed $seed triangle $n: $job")
        }
      }
      cycles.toSeq
    }

    private def load(dut: EdgeWalker, job: EdgeJob): scala.Unit = {
      other(dut)
      // six steps from cycle 0, a value a few cycles after its edge's last step
      val (stepAt, edgeAt) = EdgeJobs.times(r)
      for (cycle <- 0 to edgeAt.last) {
        val step = stepAt.indexOf(cycle)
        val edge = edgeAt.indexOf(cycle)
        dut.io.step.valid #= step >= 0
        dut.io.step.payload #= (if (step >= 0) (if (step % 2 == 0) job.stepX else job.stepY) (step / 2)
                                else r.between(-65535, 65536))
        dut.io.edge.valid #= edge >= 0
        dut.io.edge.index #= scala.math.max(edge, 0)
        dut.io.edge.value #= (if (edge >= 0) job.values(edge) else r.nextInt())
        dut.clockDomain.waitSampling()
      }
      dut.io.step.valid #= false
      dut.io.edge.valid #= false
      dut.clockDomain.waitSampling(r.nextInt(4))
      dut.io.lastColumn #= job.lastColumn
      dut.io.firstRow #= job.firstRow
      dut.io.lastRow #= job.lastRow
      dut.io.start #= true
      dut.clockDomain.waitSampling()
      dut.io.start #= false
      other(dut)
    }

    /** The triangle before and the one after may belong to tiles at other sides of the screen. */
    private def other(dut: EdgeWalker): scala.Unit = {
      dut.io.lastColumn #= r.nextInt(config.tileWidth)
      dut.io.firstRow #= r.nextInt(config.tileHeight)
      dut.io.lastRow #= r.nextInt(config.tileHeight)
    }

    private def untilIdle(dut: EdgeWalker): Int = {
      var cycles = 0
      do { dut.clockDomain.waitSampling(); cycles += 1 } while (!dut.io.idle.toBoolean && cycles < 5000)
      cycles
    }
  }

  private val tiles = Seq((4, 4), (3, 3), (5, 5), (5, 3))
  for {
    kind <- Seq(WalkerKind.Serial, WalkerKind.Parallel)
    ((log2Width, log2Height), k) <- tiles.zipWithIndex
  } {
    val unit =
      new Unit(RasterConfig(height = 240, tileLog2Width = log2Width, tileLog2Height = log2Height, walker = kind))
    val where = s"$kind, tiles of ${1 << log2Width} x ${1 << log2Height}"
    for ((what, make) <- unit.jobs.families) {
      // other tiles than the usual one with a part of the triangles
      test(s"$where: $what") { unit.walk(make().take(if (k == 0) 1500 else 150), stalled = true) }
    }
    test(s"$where: cycles are at most what rows and lateral steps allow") {
      for ((what, make) <- unit.jobs.families) {
        val jobs = make().take(if (k == 0) 400 else 100)
        for ((job, cycles) <- jobs.zip(unit.walk(jobs, stalled = false))) {
          val most = job.mostCycles(kind, unit.config.tileWidth)
          assert(cycles <= most, s"seed $seed, $what: $cycles cycles, at most $most: $job")
        }
      }
    }
  }
}
