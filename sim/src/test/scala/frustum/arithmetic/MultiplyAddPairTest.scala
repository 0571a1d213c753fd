package frustum.arithmetic

import frustum.device.Tech
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class MultiplyAddPairTest extends AnyFunSuite with Simulated {
  private val seed = 11

  test("each half is its addend and product, one clock later") {
    FrustumSim.compile("MultiplyAddPair")(MultiplyAddPair(Tech.Generic)).doSim(seed) { dut =>
      val r = new Random(seed)
      def any(corners: Int*)(of: => Int) = if (r.nextBoolean()) corners(r.nextInt(corners.size)) else of
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling()
      for (n <- 0 until 2000) {
        val operands = Seq.fill(2)(
          (
            any(-128, -1, 0, 127)(r.between(-128, 128)),
            any(0, 32, 255)(r.nextInt(256)),
            any(0, 65535)(r.nextInt(65536))
          )
        )
        for (((a, b, addend), i) <- operands.zipWithIndex) {
          dut.io.a(i) #= a
          dut.io.b(i) #= b
          dut.io.addend(i) #= addend
        }
        dut.clockDomain.waitSampling()
        sleep(1)
        for (((a, b, addend), i) <- operands.zipWithIndex)
          assert(dut.io.result(i).toInt == ((addend + a * b) & 0xffff), s"seed $seed, $n: half $i of $operands")
      }
    }
  }
}
