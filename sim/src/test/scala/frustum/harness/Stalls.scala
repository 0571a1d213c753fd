package frustum.harness

/** How often the source offers (`valid`) and the sink takes (`ready`), as probabilities per clock; 1 means
  * always.
  */
final case class Stalls(valid: Double, ready: Double) {
  require(valid > 0 && valid <= 1 && ready > 0 && ready <= 1, s"stalls $this: rates lie in (0, 1]")
}

object Stalls {
  val Never = Stalls(1, 1)

  /** Full rate, both sides random, a slow sink, a slow source: what a unit test runs by default. */
  val All: Seq[Stalls] = Seq(Never, Stalls(0.5, 0.5), Stalls(1, 0.25), Stalls(0.25, 1))
}
