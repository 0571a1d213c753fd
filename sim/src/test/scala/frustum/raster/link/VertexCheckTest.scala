package frustum.raster.link

import frustum.contract.raster.{PackedVertex, VertexRanges}
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class VertexCheckTest extends AnyFunSuite with Simulated {
  private val seed = 15

  for (
    ranges <- Seq(
      VertexRanges(),
      VertexRanges(position = 9, repeats = 1),
      VertexRanges(position = 4, repeats = 0),
      VertexRanges(position = 6, repeats = 5)
    )
  )
    test(s"$ranges: refuses what the vertex's own rule refuses, as soon as it is known") {
      FrustumSim.compile("VertexCheck")(VertexCheck(ranges)).doSim(seed) { dut =>
        val r = new Random(seed)
        val good = PackedVertex(0, 0, 0, 32768, 0, 0, 0, 0, 0, 0, 0).words
        val edges = Seq(0, 1, 0x3f, 0x40, 0x7f, 0x80, 0x3fff, 0x4000, 0x4001, 0x7fff, 0x8000, 0x8001, 0xbfff,
          0xc000, 0xc001, 0xffff)
        // what is just within the ranges and just beyond
        val near = for (
          m <- Seq(ranges.maxXy, ranges.maxXy + 1, ranges.maxSt, ranges.maxSt + 1); v <- Seq(m, -m);
          w <- Seq(0, 1, 4, 6)
        )
          yield
            if (w < 2) good.updated(w, v & 0xffff)
            else good.updated(w, v >> 16 & 0x7ff).updated(w + 1, v & 0xffff)
        val vertices = near ++
          // each word at its limits, each pair of texture words at theirs
          (for (w <- 0 until PackedVertex.WireWords; v <- edges) yield good.updated(w, v)) ++
          (for (w <- Seq(4, 6); high <- 0 to 0x7ff; low <- Seq(0, 1, 0xffff))
            yield good.updated(w, r.nextInt(32) << 11 | high).updated(w + 1, low)) ++
          Seq.fill(3000)(good.map(w =>
            if (r.nextInt(8) == 0) edges(r.nextInt(edges.size))
            else if (r.nextBoolean()) r.nextInt(65536) else w
          )) ++
          Seq.fill(2000) {
            def within(most: Int) = r.between(-most, most + 1)
            PackedVertex(
              within(ranges.maxXy),
              within(ranges.maxXy),
              r.nextInt(65536),
              r.between(32768, 65536),
              r.nextInt(32),
              within(ranges.maxSt),
              within(ranges.maxSt),
              r.nextInt(256),
              r.nextInt(256),
              r.nextInt(256),
              r.nextInt(256)
            ).words
          }

        dut.io.clear #= false
        dut.io.word.valid #= false
        dut.clockDomain.forkStimulus(10)
        dut.clockDomain.waitSampling()
        var refused = 0
        def judge(v: Seq[Int], i: Int, n: Int): Unit = {
          // what is still to come is taken to be good; half a texture coordinate tells nothing of its lowest value
          val known = if (i % 2 == 0 && i > 1) i else i + 1
          val should = PackedVertex.decode(v.take(known) ++ good.drop(known)).fault(ranges).isDefined
          val fault = dut.io.fault.toBoolean
          def where = s"seed $seed vertex $n, word $i of ${v.map(w => f"$w%04x").mkString(" ")}"
          if (i % 2 == 1) assert(fault == should, where) else assert(!should || fault, where)
        }
        for ((v, n) <- vertices.zipWithIndex) {
          dut.io.clear #= true
          dut.clockDomain.waitSampling()
          dut.io.clear #= false
          // A word, in the clock after it what it is, after that the verdict; the next word comes at once or later.
          for (i <- 0 to v.size) {
            dut.io.word.valid #= i < v.size
            dut.io.word.payload #= (if (i < v.size) v(i) else r.nextInt(65536))
            dut.io.pair #= (i - 1).max(0) / 2
            dut.io.second #= i % 2 == 0
            dut.clockDomain.waitSampling()
            dut.io.word.valid #= false
            sleep(1)
            if (i > 0) judge(v, i - 1, n)
            val gap = if (n % 2 == 0) 0 else r.nextInt(3)
            if (gap > 0) {
              dut.io.word.payload #= r.nextInt(65536)
              dut.io.pair #= i / 2
              dut.io.second #= i % 2 == 1
              dut.clockDomain.waitSampling(gap)
            }
          }
          if (dut.io.fault.toBoolean) refused += 1
        }
        assert(refused > 1000 && vertices.size - refused > 1000, s"$refused of ${vertices.size} refused")
      }
    }
}
