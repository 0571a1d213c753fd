package frustum.demos.voxel

import frustum.engine.EngineSim
import frustum.harness.Simulated
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import scala.collection.mutable

class HostFramingTest extends AnyFunSuite with Simulated {
  private val Silence = 30
  private val bytesOf = Map(0x41 -> 1, 0x5a -> 6)

  test("whole commands come through as they are; whatever else comes is counted, up to 255 (seed 1)") {
    EngineSim.compile("HostFraming")(HostFraming(bytesOf, Silence)).doSim("random", 1) { dut =>
      val random = simRandom
      val got, want = mutable.Buffer.empty[(Int, Seq[Int])]
      val payload = mutable.Buffer.empty[Int]
      var bad = 0
      var toRefuse = false
      dut.io.bytes.valid #= false
      dut.io.refuse #= false
      dut.clockDomain.forkStimulus(EngineSim.Period)
      dut.clockDomain.waitSampling(20)

      def send(byte: Int): Unit = {
        dut.io.bytes.valid #= true
        dut.io.bytes.payload #= byte
        sleep(1)
        if (dut.io.begins.toBoolean) payload.clear()
        if (dut.io.payload.valid.toBoolean) payload += dut.io.payload.payload.toInt
        if (dut.io.whole.toBoolean) got += ((dut.io.opcode.toInt, payload.toSeq))
        dut.io.refuse #= dut.io.whole.toBoolean && toRefuse
        dut.clockDomain.waitSampling()
        dut.io.bytes.valid #= false
        dut.io.refuse #= false
        dut.clockDomain.waitSampling(random.nextInt(Silence / 2))
      }
      def command(opcode: Int): Seq[Int] = {
        val body = opcode +: Seq.fill(bytesOf(opcode))(random.nextInt(256))
        body :+ (-body.sum & 255)
      }

      for (n <- 0 until 700) {
        val good = command(if (random.nextBoolean()) 0x41 else 0x5a)
        toRefuse = false
        random.nextInt(6) match {
          case 0 => // a sum that is wrong
            bad += 1
            good.updated(good.length - 1, good.last + 1 + random.nextInt(255) & 255).foreach(send)
          case 1 => // cut short
            bad += 1
            good.take(1 + random.nextInt(good.length - 1)).foreach(send)
            dut.clockDomain.waitSampling(Silence + 2)
          case 2 => // no opcode
            bad += 1
            send(Iterator.continually(random.nextInt(256)).find(!bytesOf.contains(_)).get)
          case 3 => // refused by its user
            bad += 1
            toRefuse = true
            good.foreach(send)
            want += ((good.head, good.tail.init))
          case _ =>
            good.foreach(send)
            want += ((good.head, good.tail.init))
        }
        dut.clockDomain.waitSampling()
        assert(got == want, s"after $n commands")
        assert(dut.io.refused.toInt == bad.min(255), s"after $n commands")
      }
      assert(bad > 300)
    }
  }
}
