package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.raster.fragment.Fragment
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

class AttributeMemoryTest extends AnyFunSuite with Simulated {
  private val seed = 2

  /** Attributes as the memory shows them: place, end mark, colours with nine bits. */
  private case class Shown(x: Int, y: Int, end: Boolean, colors: Seq[Int])

  test("attributes and depths come back in order") {
    val config = RasterConfig(height = 240, tileLog2Width = 5, tileLog2Height = 3)
    FrustumSim.compile("AttributeMemory")(AttributeMemory(config)).doSim(seed) { dut =>
      val r = new Random(seed)
      val attributes = ArrayBuffer.empty[Shown]
      val depths = ArrayBuffer.empty[Int]
      var fetched, depthFetched = 0
      dut.io.push.valid #= false
      dut.io.fetch #= false
      dut.io.fetchDepth #= false
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling()
      for (clock <- 0 until 20000) {
        // fits of filling and of draining, up to the fifteen that the pointers tell from none
        val filling = clock / 40 % 2 == 0
        val push =
          attributes.length - depthFetched < AttributeMemory.Words - 1 && r.nextInt(4) < (if (filling) 3
                                                                                          else 1)
        val fetch = fetched < attributes.length && r.nextInt(4) < (if (filling) 1 else 3)
        val fetchDepth = depthFetched < fetched && r.nextInt(4) < (if (filling) 1 else 3)
        val p = dut.io.push
        p.valid #= push
        p.payload.randomize()
        p.z #= (if (r.nextInt(3) == 0) r.nextInt(4) << 29 else r.nextInt())
        dut.io.fetch #= fetch
        dut.io.fetchDepth #= fetchDepth
        sleep(1)
        assert(
          dut.io.empty.toBoolean == (depthFetched == attributes.length),
          s"seed $seed clock $clock: empty"
        )
        if (fetched > 0) {
          val a = dut.io.attributes
          val got = Shown(a.x.toInt, a.y.toInt, a.tileEnd.toBoolean, Seq(a.r, a.g, a.b, a.a).map(_.toInt))
          assert(got == attributes(fetched - 1), s"seed $seed clock $clock: attributes ${fetched - 1}")
        }
        if (depthFetched > 0) assert(
          dut.io.z.toInt == depths(depthFetched - 1),
          s"seed $seed clock $clock: depth ${depthFetched - 1}"
        )
        if (push) {
          depths += Fragment.depth(p.z.toInt)
          attributes += Shown(
            p.x.toInt,
            p.y.toInt,
            p.tileEnd.toBoolean,
            Seq(p.r, p.g, p.b, p.a).map(v => v.toInt >> 7 & 511)
          )
        }
        if (fetch) fetched += 1
        if (fetchDepth) depthFetched += 1
        dut.clockDomain.waitSampling()
      }
      assert(depthFetched > 5000, s"only $depthFetched went through")
    }
  }
}
