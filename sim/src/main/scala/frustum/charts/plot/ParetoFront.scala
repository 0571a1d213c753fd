package frustum.charts.plot

/** The points of a set that are worth their cost. */
object ParetoFront {

  /** Those that no other beats in one and equals in the other, by rising cost; less is better in both. Equal ones are
    * all kept.
    */
  def apply[A](all: Seq[A])(cost: A => Double, error: A => Double): Seq[A] =
    all.filterNot(p =>
      all.exists(o => cost(o) <= cost(p) && error(o) <= error(p) && (cost(o) < cost(p) || error(o) < error(p)))
    ).sortBy(p => (cost(p), error(p)))
}
