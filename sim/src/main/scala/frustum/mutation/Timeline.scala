package frustum.mutation

import scala.collection.mutable
import scala.util.Random

/** Steps of a unit that never waits, written down by clock. */
final class Timeline {
  private val inputs, expected = mutable.Map.empty[Int, Map[String, BigInt]]
  private var end = 0

  private def add(to: mutable.Map[Int, Map[String, BigInt]], clock: Int, ports: Seq[(String, Long)]): Unit = {
    to(clock) = to.getOrElse(clock, Map.empty) ++ MutationPlan.values(ports: _*)
    end = end.max(clock + 1)
  }
  def drive(clock: Int, ports: (String, Long)*): Unit = add(inputs, clock, ports)
  def expect(clock: Int, ports: (String, Long)*): Unit = add(expected, clock, ports)

  /** The resolver holds a bank in this clock without clearing any of it. */
  def hold(clock: Int, bank: Int): Unit =
    drive(
      clock,
      "io_clear_active" -> 1,
      "io_clear_bank" -> bank.toLong,
      "io_clear_write" -> 0,
      "io_clear_read" -> 0
    )

  /** Clears a bank of the tile memory, or both, word after word as the resolver does, two clocks each.
    *
    * @param read told the clock in which a word that was read shows
    * @return the first clock after
    */
  def sweep(from: Int, words: Int, bank: Option[Int])(read: (Int, Int) => Unit): Int = {
    for (a <- 0 until words; write <- 0 to 1) {
      val clock = from + 2 * a + write
      drive(
        clock,
        "io_clear_all" -> (if (bank.isEmpty) 1 else 0),
        "io_clear_active" -> (if (bank.isDefined) 1 else 0),
        "io_clear_bank" -> bank.getOrElse(0).toLong,
        "io_clear_read" -> (1 - write),
        "io_clear_write" -> write,
        "io_clear_readAddress" -> a,
        "io_clear_writeAddress" -> a
      )
      if (write == 1) read(clock, a)
    }
    from + 2 * words
  }

  /** @param loose ports with their bits that show anything at all where nothing is said of them */
  def steps(r: Random, loose: Seq[(String, Int)]): IndexedSeq[MutationStep] = (0 until end).map { t =>
    val any = loose.map { case (port, bits) => port -> BigInt(bits, r) }
    MutationStep(any.toMap ++ inputs.getOrElse(t, Map.empty), expected.getOrElse(t, Map.empty))
  }
}

object Timeline {

  /** What the resolver says while it holds no bank. */
  def idleClear(addressBits: Int): Seq[(String, Int)] = Seq(
    "io_clear_bank" -> 1,
    "io_clear_read" -> 1,
    "io_clear_write" -> 1,
    "io_clear_readAddress" -> addressBits,
    "io_clear_writeAddress" -> addressBits
  )
}
