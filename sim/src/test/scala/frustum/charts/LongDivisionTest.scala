package frustum.charts

import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random
import spinal.core.sim._

class LongDivisionTest extends AnyFunSuite with Simulated {
  private val fraction = 12

  test("the charted divider divides: hardware equals whole-number division, a pair a clock") {
    val random = new Random(1)
    val inputs = Seq.fill(300) {
      val q = 2 + random.nextInt(Int.MaxValue - 2) >> random.nextInt(16)
      def numerator = if (q < 2) 0 else random.between(1 - q, q)
      (numerator, numerator, q.max(1))
    }
    val expected = inputs.map { case (s, t, q) => (LongDivision(s, q, fraction), LongDivision(t, q, fraction)) }
    FrustumSim.compile("LongDivision")(new LongDivision(fraction)).doSim("LongDivision", 1) { dut =>
      dut.clockDomain.forkStimulus(10)
      val latency = dut.rows + 1
      for (clock <- 0 until inputs.length + latency) {
        val (s, t, q) = inputs(clock.min(inputs.length - 1))
        dut.io.s #= s
        dut.io.t #= t
        dut.io.q #= q
        dut.clockDomain.waitSampling()
        val at = clock - latency
        if (at >= 0) assert((dut.io.sq.toLong, dut.io.tq.toLong) == expected(at), s"${inputs(at)}")
      }
    }
  }
}
