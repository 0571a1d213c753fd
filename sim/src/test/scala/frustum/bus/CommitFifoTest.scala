package frustum.bus

import frustum.harness.{FrustumSim, Simulated}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class CommitFifoTest extends AnyFunSuite with Simulated {
  private val seed = 13

  /** What the writer does in a clock and how often, and how often the reader takes. */
  private case class Mood(push: Double, commit: Double, rollback: Double, ready: Double)
  private val moods = Seq(
    Mood(1, 0.1, 0.02, 1),
    Mood(1, 0.05, 0.01, 0.2),
    Mood(0.3, 0.2, 0.1, 0.8),
    Mood(1, 0, 0.01, 0.5),
    Mood(0.8, 0.4, 0, 0),
    Mood(1, 1, 0, 1)
  )

  for ((depth, margin) <- Seq(8 -> 3, 256 -> 16, 64 -> 63))
    test(s"$depth words, margin $margin") {
      FrustumSim.compile(s"CommitFifo_$depth")(CommitFifo(depth, margin)).doSim(seed) { dut =>
        val r = new Random(seed)
        val fifo = new model.bus.CommitFifo
        var popped, lost, rolledBack = 0
        var offered: Option[Int] = None // a word that the reader did not take
        var heldBefore, heldEarlier = 0
        var calm, streamed = 0 // clocks in which everything went through at once
        Seq(dut.io.push.valid, dut.io.commit, dut.io.rollback, dut.io.pop.ready).foreach(_ #= false)
        dut.clockDomain.forkStimulus(10)
        dut.clockDomain.waitSampling(2)
        for (clock <- 0 until 30000) {
          val mood = moods(clock / 500 % moods.size)
          def chance(p: Double) = r.nextDouble() < p
          // A rollback goes alone: what is pushed with it is not spoken of, nor both changes of mind at once.
          val rollback = chance(mood.rollback)
          val (push, commit) = (!rollback && chance(mood.push), !rollback && chance(mood.commit))
          val ready = chance(mood.ready)
          val word = r.nextInt(65536)
          dut.io.push.valid #= push
          dut.io.push.payload #= word
          dut.io.commit #= commit
          dut.io.rollback #= rollback
          dut.io.pop.ready #= ready
          sleep(1)
          def where = s"seed $seed clock $clock"
          val valid = dut.io.pop.valid.toBoolean
          val full = dut.io.full.toBoolean
          if (valid) {
            val got = dut.io.pop.payload.toInt
            offered.foreach(was => assert(got == was, s"$where: a word changed while it waited"))
            assert(fifo.readable > 0, s"$where: $got was not committed")
            offered = Some(got)
          } else assert(offered.isEmpty, s"$where: a word was withdrawn")
          assert(
            !full || fifo.held >= depth - 3 || heldBefore >= depth - 3,
            s"$where: full with ${fifo.held} words"
          )
          val free = depth - 1 - heldEarlier
          assert(
            dut.io.room.toBoolean == (free >= margin) || (free - margin).abs <= 2,
            s"$where: room with $free words free"
          )
          heldEarlier = heldBefore
          heldBefore = fifo.held
          if (mood == moods.last && clock % 500 > depth + 20) {
            calm += 1; if (valid && ready && push && !full) streamed += 1
          }

          dut.clockDomain.waitSampling()
          if (valid && ready) {
            assert(fifo.pop() == offered.get, s"$where: word $popped"); popped += 1; offered = None
          }
          // the order tells that both concern words of earlier clocks
          if (commit) fifo.commit()
          if (rollback) { rolledBack += 1; fifo.rollback() }
          if (push) if (full) lost += 1 else fifo.push(word)
        }
        assert(
          popped > 5000 && lost > 100 && rolledBack > 100,
          s"popped $popped, lost $lost, rolled back $rolledBack"
        )
        assert(streamed == calm && (calm > 100 || depth > 200), s"$streamed of $calm clocks passed a word")
      }
    }
}
