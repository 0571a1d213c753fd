package frustum.engine

import frustum.contract.video.VideoMode
import frustum.harness.{FrustumSim, Simulated}
import frustum.peripheral.SimVideoMonitor
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._

/** Counters for a picture: colour is column plus frame, plus one so that it is never black. */
case class BeamPattern(mode: VideoMode) extends Component {
  val io = new Bundle { val run = in Bool () }
  val monitor = SimVideoMonitor(mode, 12)
  val h = Reg(UInt(12 bits)).init(0).simPublic()
  val v = Reg(UInt(12 bits)) init mode.vTotal - 4 // so that there are lines to lock to
  val f = Reg(UInt(12 bits)) init 4095
  when(io.run) {
    h := h + 1
    when(h === mode.hTotal - 1) {
      h := 0
      v := v + 1
      when(v === mode.vTotal - 1) { v := 0; f := f + 1 }
    }
  }
  private val left = mode.hSync + mode.hBack
  private val top = mode.vSync + mode.vBack
  private val active = h >= left && h < left + mode.width && v >= top && v < top + mode.height
  monitor.io.pins.hSync := (h < mode.hSync) === Bool(mode.hPositive)
  monitor.io.pins.vSync := (v < mode.vSync) === Bool(mode.vPositive)
  monitor.io.pins.active := active
  monitor.io.pins.color := Mux(active, (h - left + f + 1).asBits, B(0))
}

class VideoSessionTest extends AnyFunSuite with Simulated {
  private val mode = VideoMode("small", 1, 64, 32, 2, 3, 4, 1, 2, 3, hPositive = true, vPositive = false)
  private lazy val compiled = FrustumSim.compile("VideoSession")(BeamPattern(mode))

  private def run(body: (BeamPattern, VideoSession) => Unit): Unit = compiled.doSim("seed1", 1) { dut =>
    dut.io.run #= false
    dut.clockDomain.forkStimulus(EngineSim.Period)
    dut.clockDomain.waitSampling(20)
    body(dut, new VideoSession(dut.monitor)(EngineSim.clocks(dut.clockDomain)))
  }

  private def sixFrames(dut: BeamPattern, session: VideoSession): Unit = {
    dut.io.run #= true
    for (f <- 0 until 6) {
      session.frame()
      assert(session.reader.picture().toSeq == Seq.tabulate(64 * 32)(i => i % 64 + f + 1), s"frame $f")
    }
    assert(session.reader.errors == 0 && session.reader.clocksPerFrame == mode.hTotal * mode.vTotal)
  }

  test("every frame is seen once, in its order")(run(sixFrames))

  test("the same when the simulator is clocked directly") {
    compiled.doSim("direct", 1) { dut =>
      dut.io.run #= false
      val clock = new DirectClock(dut.clockDomain)
      clock.run(20)
      sixFrames(dut, new VideoSession(dut.monitor)(clock.run))
    }
  }

  test("an input that is changed between two runs holds from the first clock of the second") {
    compiled.doSim("input", 1) { dut =>
      dut.io.run #= false
      val clock = new DirectClock(dut.clockDomain)
      clock.run(5)
      val before = dut.h.toInt
      dut.io.run #= true
      clock.run(7)
      assert(dut.h.toInt == before + 7)
      dut.io.run #= false
      clock.run(3)
      assert(dut.h.toInt == before + 7)
    }
  }

  test("a system without a picture does not run for ever") {
    run { (_, session) =>
      assert(intercept[IllegalStateException](session.frame()).getMessage.contains("hangs"))
    }
  }
}
