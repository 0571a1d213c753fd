package frustum.demos.pad

import frustum.harness.{FrustumSim, Simulated}
import frustum.peripheral.SimConsolePad
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import scala.util.Random

/** A pad's state by its wires. */
class ConsolePadTest extends AnyFunSuite {
  private val clockHz = 1000000L
  private lazy val compiled = FrustumSim.compile("ConsolePad")(ConsolePad(clockHz))

  /** Connected, the 16 buttons from select on, the four sticks. */
  private type Held = (Boolean, Seq[Boolean], Seq[Int])
  private val rest: Held = (false, Seq.fill(16)(false), Seq.fill(4)(128))

  private def session(seed: Int)(body: (SimConsolePad, () => Held, Random) => Unit): Unit =
    compiled.doSim(seed) { dut =>
      dut.io.poll #= false
      val pad = new SimConsolePad(dut.io.pins, dut.clockDomain)
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(5)
      def ask(): Held = {
        dut.io.poll #= true
        dut.clockDomain.waitSampling()
        dut.io.poll #= false
        assert(!dut.clockDomain.waitSamplingWhere(4000)(dut.io.done.toBoolean), "no end of an answer")
        val s = dut.io.state
        (s.connected.toBoolean, s.buttons.map(_.toBoolean), s.sticks.map(_.toInt))
      }
      body(pad, () => ask(), new Random(seed))
    }

  private def bytes(id: Int, held: Seq[Boolean], sticks: Seq[Int]): Seq[Int] =
    Seq(id, 0x5a) ++ held.grouped(8).map(_.zipWithIndex.map { case (h, i) =>
      if (h) 0 else 1 << i
    }.sum) ++ sticks

  test("digital and analogue pads: every button, every stick (seed 1)", Simulated) {
    session(1) { (pad, ask, random) =>
      for (i <- 0 until 16; sticks <- Seq(Nil, Seq(1, 2, 254, 255))) {
        val held = Seq.tabulate(16)(_ == i)
        pad.answer = bytes(if (sticks.isEmpty) 0x41 else 0x73, held, sticks)
        assert(ask() == ((true, held, if (sticks.isEmpty) rest._3 else sticks)), s"button $i")
      }
      for (_ <- 0 until 40) {
        val (held, sticks) = (Seq.fill(16)(random.nextBoolean()), Seq.fill(4)(random.nextInt(255)))
        pad.answer = bytes(0x73, held, sticks)
        assert(ask() == ((true, held, sticks)))
      }
    }
  }

  test(
    "pads with pressures, joysticks and a wheel: the whole answer is fetched, buttons and sticks count (seed 4)",
    Simulated
  ) {
    session(4) { (pad, ask, random) =>
      for (i <- 0 until 16; (id, rest, moves) <- Seq((0x79, 12, true), (0x53, 0, true), (0xe3, 0, false))) {
        val held = if (i < 8) Seq.fill(16)(random.nextBoolean()) else Seq.tabulate(16)(_ == 2 * i - 16)
        val sticks = Seq.fill(4)(random.nextInt(255))
        pad.answer = bytes(id, held, sticks) ++ Seq.fill(rest)(random.nextInt(256))
        assert(ask() == ((true, held, if (moves) sticks else this.rest._3)), f"id 0x$id%02x")
        assert(pad.asked == Seq(0x01, 0x42).padTo(pad.due, 0), f"id 0x$id%02x")
      }
    }
  }

  test(
    "a pad with pressures that goes away before its sticks are through is at rest; later its sticks still count",
    Simulated
  ) {
    session(5) { (pad, ask, _) =>
      val (held, sticks) = (Seq.tabulate(16)(_ % 3 == 0), Seq(9, 8, 7, 6))
      val whole = bytes(0x79, held, sticks) ++ Seq.fill(12)(80)
      for (n <- 1 to 4) {
        pad.answer = whole.take(n)
        assert(ask() == rest, s"after $n bytes")
      }
      for (n <- 8 to 20) {
        pad.answer = whole.take(n)
        assert(ask() == ((true, held, sticks)), s"after $n bytes")
      }
    }
  }

  test(
    "the wires: 01 42 and zeros, five bytes for a digital pad and nine for sticks, SCK at 83 kHz at most",
    Simulated
  ) {
    session(2) { (pad, ask, _) =>
      for ((id, count) <- Seq(0x41 -> 5, 0x73 -> 9)) {
        pad.answer = bytes(id, Seq.fill(16)(false), Seq.fill(4)(128))
        ask()
        assert(pad.asked == Seq(0x01, 0x42).padTo(count, 0))
        assert(pad.shortest >= 12 && pad.longest <= 13, "clocks of 1 us between falling edges")
      }
    }
  }

  test(
    "no pad, another id, no 5A, a pad unplugged at any byte: at rest, and right again with the next answer",
    Simulated
  ) {
    session(3) { (pad, ask, random) =>
      val good = bytes(0x73, Seq.fill(16)(true), Seq(3, 4, 5, 6))
      val wrong = Seq(
        Nil,
        good.updated(0, 0x23),
        good.updated(0, 0xf3),
        good.updated(0, 0x12),
        good.updated(0, 0xff),
        good.updated(0, 0),
        good.updated(1, 0),
        Seq.fill(8)(0)
      ) ++
        (1 to 4).map(good.take)
      for (answer <- random.shuffle(wrong)) {
        pad.answer = answer
        assert(ask() == rest, answer)
        pad.answer = good
        assert(ask()._1, "not right again")
      }
    }
  }

  test("a clock too slow for SCK is refused") {
    intercept[IllegalArgumentException](FrustumSim.spinalConfig.generateVerilog(ConsolePad(100000)))
  }
}
