package frustum.peripheral

import frustum.contract.video.VideoMode
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

/** A signal whose every clock is known, with and without faults. */
class SimVideoMonitorTest extends AnyFunSuite with Simulated {
  private val mode = VideoMode("small", 1, 16, 8, 2, 3, 4, 1, 2, 3, hPositive = false, vPositive = true)
  import mode.{hTotal, vTotal}
  private val left = mode.hSync + mode.hBack
  private case class Clock(h: Boolean, v: Boolean, active: Boolean, color: Int)
  private def color(frame: Int, x: Int, y: Int) = new Random(frame * 1000 + y * 16 + x).nextInt(4096)

  /** Frames from the start of the horizontal pulse; the vertical one starts `phase` clocks later. */
  private def signal(frames: Int, phase: Int = 0): IndexedSeq[Clock] =
    for (f <- 0 until frames; line <- 0 until vTotal; column <- 0 until hTotal) yield {
      val (x, y) = (column - left, line - mode.vSync - mode.vBack)
      val active = x >= 0 && x < mode.width && y >= 0 && y < mode.height
      val since = line * hTotal + column - phase
      Clock(
        column < mode.hSync,
        since >= 0 && since < mode.vSync * hTotal,
        active,
        if (active) color(f, x, y) else 0
      )
    }

  private lazy val compiled = FrustumSim.compile("SimVideoMonitor")(SimVideoMonitor(mode, 12))

  /** Sends the clocks; gives wrong measures by name. `at` is called after so many. */
  private def run(clocks: Seq[Clock])(body: SimVideoReader => Unit = _ => ()): Map[String, VideoMeasure] = {
    var result = Map.empty[String, VideoMeasure]
    compiled.doSim(s"seed1", 1) { dut =>
      def put(c: Clock): Unit = {
        dut.io.pins.hSync #= c.h == mode.hPositive
        dut.io.pins.vSync #= c.v == mode.vPositive
        dut.io.pins.active #= c.active
        dut.io.pins.color #= c.color
      }
      put(Clock(h = false, v = false, active = false, 0))
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(5)
      for (c <- clocks) { put(c); dut.clockDomain.waitSampling() }
      dut.clockDomain.waitSampling(2)
      val reader = new SimVideoReader(dut)
      body(reader)
      result = reader.measures.map(m => m.name -> m).toMap
      assert(reader.errors == result.values.map(_.wrong).sum)
    }
    result
  }
  private def wrong(m: Map[String, VideoMeasure]) = m.values.filter(_.wrong > 0).map(_.name).toSet

  // The start of a further frame ends the last.
  private def frames(n: Int, phase: Int = 0) = signal(n + 1, phase).dropRight(hTotal * vTotal - phase - 1)

  for (phase <- Seq(0, mode.hSync, left))
    test(s"a clean signal, vertical pulse $phase clocks into the line") {
      val m = run(frames(3, phase)) { reader =>
        assert(reader.frames == 3 && reader.errors == 0 && reader.clocksPerFrame == hTotal * vTotal)
        val sent = for (y <- 0 until mode.height; x <- 0 until mode.width) yield color(2, x, y)
        assert(reader.picture().toSeq == sent)
      }
      val got = Seq("hTotal", "hSync", "hBack", "width", "hFront").map(m(_).last)
      assert(got == Seq(mode.hTotal, mode.hSync, mode.hBack, mode.width, mode.hFront))
      assert(m("vSync").last == mode.vSync * hTotal && m("vTotal").measured == 3)
    }

  /** Changes clocks of the second frame, whose line and column are told. */
  private def changed(line: Int, columns: Range)(change: Clock => Clock): IndexedSeq[Clock] = {
    val s = frames(3)
    columns.foldLeft(s)((s, c) => { val at = (vTotal + line) * hTotal + c; s.updated(at, change(s(at))) })
  }
  private val line = mode.vSync + mode.vBack + 3

  test("a horizontal pulse late by one clock") {
    val s = changed(line, 0 until 1)(_.copy(h = false))
    assert(Set("hTotal", "hSync", "hFront").subsetOf(wrong(run(s)())))
    val moved = (vTotal + line) * hTotal + mode.hSync
    val w = run(s.updated(moved, s(moved).copy(h = true)))()
    assert(Set("hTotal", "hBack", "hFront", "misplaced").subsetOf(wrong(w)))
    assert(w("hTotal").wrong == 2 && w("hTotal").lastWrong == hTotal - 1)
  }

  test("a horizontal pulse that is missing") {
    val w = run(changed(line, 0 until mode.hSync)(_.copy(h = false)))()
    assert(w("hTotal").wrong == 1 && w("hTotal").lastWrong == 2 * hTotal)
  }

  test("a vertical pulse that is missing, or a line longer") {
    val none = run((0 until mode.vSync).foldLeft(frames(3)) { (s, l) =>
      (0 until hTotal).foldLeft(s)((s, c) =>
        s.updated((vTotal + l) * hTotal + c, s((vTotal + l) * hTotal + c).copy(v = false))
      )
    })()
    assert(none("vTotal").wrong == 1 && none("vTotal").lastWrong == 2 * hTotal * vTotal)
    val long = run(changed(mode.vSync, 0 until hTotal)(_.copy(v = true)))()
    assert(Set(
      "vSync",
      "vBack"
    ).subsetOf(wrong(long)) && long("vSync").lastWrong == (mode.vSync + 1) * hTotal)
  }

  test("a porch of the wrong width, a pixel too many, a colour where there is none, a line that stays dark") {
    val early = changed(line, left - 1 until left)(_.copy(active = true))
    assert(wrong(run(early)()) == Set("hBack", "width", "misplaced"))
    val short =
      changed(line, hTotal - mode.hFront - 1 until hTotal - mode.hFront)(_.copy(active = false, color = 0))
    assert(wrong(run(short)()) == Set("width", "hFront", "misplaced"))
    assert(wrong(run(changed(line, 1 until 2)(_.copy(color = 5)))()) == Set("blankColour"))
    val dark = changed(line, left until left + mode.width)(_.copy(active = false, color = 0))
    assert(run(dark)()("misplaced").wrong == mode.width)
  }
}
