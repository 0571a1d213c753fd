package frustum.mutation

import scala.collection.mutable

/** Steps of a unit that never waits, written down by clock. */
final class Timeline {
  private val inputs, expected = mutable.Map.empty[Int, Map[String, BigInt]]
  private var end              = 0

  private def add(to: mutable.Map[Int, Map[String, BigInt]], clock: Int, ports: Seq[(String, Long)]): Unit = {
    to(clock) = to.getOrElse(clock, Map.empty) ++ MutationPlan.values(ports: _*)
    end = end.max(clock + 1)
  }
  def drive(clock: Int, ports: (String, Long)*): Unit  = add(inputs, clock, ports)
  def expect(clock: Int, ports: (String, Long)*): Unit = add(expected, clock, ports)

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
        "io_clear_all"          -> (if (bank.isEmpty) 1 else 0),
        "io_clear_active"       -> (if (bank.isDefined) 1 else 0),
        "io_clear_bank"         -> bank.getOrElse(0).toLong,
        "io_clear_read"         -> (1 - write),
        "io_clear_write"        -> write,
        "io_clear_readAddress"  -> a,
        "io_clear_writeAddress" -> a
      )
      if (write == 1) read(clock, a)
    }
    from + 2 * words
  }

  def steps: IndexedSeq[MutationStep] =
    (0 until end).map(t => MutationStep(inputs.getOrElse(t, Map.empty), expected.getOrElse(t, Map.empty)))
}
