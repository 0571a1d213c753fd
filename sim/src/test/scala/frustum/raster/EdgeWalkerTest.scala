package frustum.raster

import frustum.harness.FrustumSim
import frustum.model
import frustum.spec.RasterConfig
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.sim._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

class EdgeWalkerTest extends AnyFunSuite {
  private val config = RasterConfig()

  /** Three edges as the set-up engine hands them over. */
  private case class Job(stepX: Seq[Int], stepY: Seq[Int], values: Seq[Int], lastColumn: Int, lastRow: Int) {
    def spans: Seq[String] = model.raster.EdgeWalker
      .spans(0, lastColumn, 0, lastRow, values.toArray, stepX(_), stepY(_))
      .map(s => s"${s.y}: ${s.first}..${s.last}") :+ "end"
  }

  /** A triangle of vertices in 1/16 pixel from the tile's corner; none where it faces away or is degenerate. */
  private def job(vertices: Seq[(Int, Int)], lastColumn: Int, lastRow: Int): Option[Job] = {
    val edges = vertices.zip(vertices.tail :+ vertices.head)
    val stepX = edges.map { case ((_, y0), (_, y1)) => y0 - y1 }
    val stepY = edges.map { case ((x0, _), (x1, _)) => x1 - x0 }
    val values = edges.indices.map { k =>
      val (x, y) = vertices(k)
      stepX(k).toLong * ((if (stepX(k) < 0) 16 * lastColumn else 0) + 8 - x) + stepY(k).toLong * (8 - y)
    }
    assert(values.forall(_.isValidInt), s"an edge of $vertices leaves 32 bits")
    val ((x0, y0), (x1, y1), (x2, y2)) = (vertices(0), vertices(1), vertices(2))
    Option.when((x1 - x0) * (y2 - y0).toLong > (x2 - x0) * (y1 - y0).toLong)(Job(stepX, stepY, values.map(_.toInt), lastColumn, lastRow))
  }

  private val seed = 11
  private val r    = new Random(seed)
  private def jobs(count: Int)(vertices: => Seq[(Int, Int)]): Seq[Job] =
    Iterator.continually {
      def last(size: Int) = if (r.nextBoolean()) size - 1 else r.nextInt(size)
      job(vertices, last(config.tileWidth), last(config.tileHeight))
    }.flatten.take(count).toSeq

  private def point(from: Int, until: Int) = (r.between(from, until), r.between(from, until))

  private lazy val walker = FrustumSim.compile("EdgeWalker")(EdgeWalker(config))
  private def check(jobs: Seq[Job]): Unit =
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
        dut.io.lastRow #= job.lastRow
        // six steps from clock 0, a value a few clocks after its edge's last step
        val delay = r.between(1, 14)
        val stepAt = (0 to 5).scanLeft(0)((at, _) => at + r.between(1, 5))
        val edgeAt = (0 to 2).scanLeft(-1)((at, k) => scala.math.max(at + 1, stepAt(2 * k + 1) + delay)).tail
        for (clock <- 0 to edgeAt.last) {
          val step = stepAt.indexOf(clock)
          val edge = edgeAt.indexOf(clock)
          dut.io.step.valid #= step >= 0 && step < 6
          dut.io.step.payload #= (if (step >= 0 && step < 6) (if (step % 2 == 0) job.stepX else job.stepY)(step / 2) else r.between(-65535, 65536))
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
        dut.io.lastRow #= r.nextInt(config.tileHeight)
        var clocks = 0
        do { dut.clockDomain.waitSampling(); clocks += 1 } while (!dut.io.idle.toBoolean && clocks < 5000)
        assert(got == job.spans, s"seed $seed triangle $n: $job")
      }
    }

  test("triangles in and around the tile") {
    check(jobs(1500) { val d = 1 << r.between(4, 10); Seq.fill(3)(point(-d, 256 + d)) })
  }

  test("large triangles, whose values are as large as they get") {
    def far = (r.between(-16384, 16384), r.between(-16384, 16384))
    check(jobs(300)(Seq.fill(3)(far)) ++ jobs(300)(Seq(far, far, point(0, 256))))
  }

  test("slivers with gaps between their rows") {
    check(jobs(800) {
      val (x, y) = point(-64, 320)
      val (dx, dy) = (r.between(-600, 600), r.between(-600, 600))
      Seq((x, y), (x + dx, y + dy), (x + dx + r.between(-12, 13), y + dy + r.between(-12, 13)))
    })
  }

  test("level and upright edges") {
    check(jobs(800) {
      val (x0, y0) = point(-64, 320)
      val (x1, y1) = point(-64, 320)
      r.shuffle(Seq((x0, y0), (x1, y0), if (r.nextBoolean()) (x0, y1) else (r.between(-64, 320), y1)))
    })
  }

  test("edges through pixel centres") {
    def centre = (16 * r.between(-4, 20) + 8, 16 * r.between(-4, 20) + 8)
    check(jobs(1000)(Seq.fill(3)(centre)))
  }

  test("edges that cut off the whole tile") {
    check(jobs(600) {
      val (dx, dy) = (r.between(-400, 400), r.between(-400, 400))
      Seq.fill(3)(point(0, 256)).map { case (x, y) => (x + dx, y + dy) }
    })
  }
}
