package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import frustum.harness.{FrustumSim, Simulated}
import frustum.mutation.{EdgeJob, EdgeJobs}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.sim._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

class EdgeWalkerTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig()

  private val seed = 11
  private val r = new Random(seed)
  private val jobs = new EdgeJobs(config, r)

  private lazy val walker = FrustumSim.compile("EdgeWalker")(EdgeWalker(config))
  private def check(jobs: Seq[EdgeJob]): Unit =
    walker.doSim(s"EdgeWalker_$seed", seed) { dut =>
      val got = ArrayBuffer.empty[String]
      dut.io.step.valid #= false
      dut.io.edge.valid #= false
      dut.io.start #= false
      StreamMonitor(dut.io.up, dut.clockDomain) { s =>
        got += (if (s.end.toBoolean) "end" else s"${s.y.toInt}: ${s.first.toInt}..${s.last.toInt}")
      }
      val ready = StreamReadyRandomizer(dut.io.up, dut.clockDomain)
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(5)
      for ((job, n) <- jobs.zipWithIndex) {
        ready.setFactor(if (n % 2 == 0) 2f else 0.3f)
        got.clear()
        dut.io.lastColumn #= job.lastColumn
        dut.io.firstRow #= job.firstRow
        dut.io.lastRow #= job.lastRow
        // six steps from clock 0, a value a few clocks after its edge's last step
        val (stepAt, edgeAt) = EdgeJobs.times(r)
        for (clock <- 0 to edgeAt.last) {
          val step = stepAt.indexOf(clock)
          val edge = edgeAt.indexOf(clock)
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
        dut.io.start #= true
        dut.clockDomain.waitSampling()
        dut.io.start #= false
        // the next triangle may belong to a tile at another side of the screen
        dut.io.lastColumn #= r.nextInt(config.tileWidth)
        dut.io.firstRow #= r.nextInt(config.tileHeight)
        dut.io.lastRow #= r.nextInt(config.tileHeight)
        var clocks = 0
        do { dut.clockDomain.waitSampling(); clocks += 1 } while (!dut.io.idle.toBoolean && clocks < 5000)
        assert(got == job.spans.map(s => s"${s.y}: ${s.first}..${s.last}") :+ "end", s"seed $seed triangle $n: $job")
      }
    }

  for ((what, make) <- jobs.families) test(what) { check(make()) }
}
