package frustum.video

import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

class PassThroughTest extends AnyFunSuite with Simulated {
  test("mux hands four signals to the host and leaves reset to the core") {
    FrustumSim.compile("PassThrough")(PassThrough()).doSim("all", 1) { dut =>
      import dut.io._
      for (levels <- 0 until 1024) {
        val inputs = Seq(sck, mosi, dc, cs, core.sck, core.mosi, core.dc, core.cs, core.reset, mux)
        inputs.zipWithIndex.foreach { case (pin, i) => pin #= (levels >> i & 1) != 0 }
        sleep(1)
        val source = if (mux.toBoolean) Seq(sck, mosi, dc, cs) else Seq(core.sck, core.mosi, core.dc, core.cs)
        val out = Seq(pins.sck, pins.mosi, pins.dc, pins.cs)
        assert(out.map(_.toBoolean) == source.map(_.toBoolean) && pins.reset.toBoolean == core.reset.toBoolean)
      }
    }
  }
}
