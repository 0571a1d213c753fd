package frustum.harness

import spinal.core._
import spinal.core.sim._
import spinal.lib._
import spinal.lib.sim.{StreamDriver, StreamMonitor, StreamReadyRandomizer}

import scala.collection.mutable.ArrayBuffer

/** Holds a unit with one Stream in and one Stream out to what its model says: same values, same order, same
  * number, under random valid and ready. Every failure names the seed and the stalls, which reproduce it.
  *
  * {{{
  * Equality(compiled)(_.io.up, _.io.down)((a: Thing, v: Int) => a.x #= v, (b: Other) => b.y.toInt)
  *   .run(inputs, inputs.map(model), seed = 1, minThroughput = Some(1.0))
  * }}}
  *
  * @param drive
  *   writes an input value to the payload, @param read takes an output value from it
  */
final case class Equality[C <: Component, A <: Data, B <: Data, I, O](compiled: SimCompiled[C])(
    up: C => Stream[A],
    down: C => Stream[B]
)(drive: (A, I) => Unit, read: B => O) {

  /** Runs once per entry of `stalls`.
    *
    * @param minThroughput
    *   least (items / clocks) between the first item in and the last out, asserted where both sides never
    *   stall; items are inputs or outputs, whichever are more
    * @param maxGap
    *   clocks without any transfer after which the unit counts as hung
    * @param setup
    *   drives whatever else the unit has; called before reset is released
    * @param done
    *   last look at the unit when it has delivered everything
    */
  def run(
      inputs: Seq[I],
      expected: Seq[O],
      seed: Int,
      stalls: Seq[Stalls] = Stalls.All,
      minThroughput: Option[Double] = None,
      maxGap: Int = 5000,
      setup: C => Unit = (_: C) => (),
      done: C => Unit = (_: C) => ()
  ): Unit = stalls.foreach { s =>
    val where = s"seed $seed, $s"
    compiled.doSim(s"seed${seed}_v${s.valid}_r${s.ready}", seed) { dut =>
      val clock = dut.clockDomain
      val got = ArrayBuffer.empty[O]
      var sent = 0
      var cycle = 0L
      var firstIn = -1L
      var lastMove = 0L

      val source = StreamDriver(up(dut), clock) { payload =>
        val more = sent < inputs.length
        if (more) { drive(payload, inputs(sent)); sent += 1 }
        more
      }
      source.transactionDelay = () => {
        var n = 0
        while (simRandom.nextDouble() > s.valid) n += 1
        n
      }
      StreamReadyRandomizer(down(dut), clock).setFactor(if (s.ready == 1) 2f else s.ready.toFloat)
      StreamMonitor(up(dut), clock) { _ => if (firstIn < 0) firstIn = cycle; lastMove = cycle }
      StreamMonitor(down(dut), clock) { payload => got += read(payload); lastMove = cycle }
      clock.onSamplings(cycle += 1)

      setup(dut)
      clock.forkStimulus(period = 10)
      while (got.length < expected.length && cycle - lastMove < maxGap) clock.waitSampling(16)
      val clocks = lastMove - firstIn + 1
      clock.waitSampling(64) // nothing may follow

      val wrong = got.indices.find(i => i >= expected.length || got(i) != expected(i))
      wrong.foreach { i =>
        val should = if (i < expected.length) s"should be ${expected(i)}" else "should not be there"
        throw new AssertionError(s"$where: output $i of ${expected.length} is ${got(i)}, $should")
      }
      assert(
        got.length == expected.length,
        s"$where: ${got.length} of ${expected.length} outputs, then $maxGap clocks idle"
      )
      assert(sent == inputs.length, s"$where: only $sent of ${inputs.length} inputs taken")
      minThroughput.filter(_ => s == Stalls.Never).foreach { least =>
        val rate = inputs.length.max(expected.length).toDouble / clocks
        assert(rate >= least, f"$where: $rate%.4f items a clock, at least $least%.4f promised")
      }
      done(dut)
    }
  }
}
