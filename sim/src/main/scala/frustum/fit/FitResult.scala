package frustum.fit

import scala.math.pow

/** The answer.
  *
  * @param trained,heldOut    views with their errors
  * @param oneBitLess for each number of bits, the worst share of the budget with one bit less: above [[Fit.Margin]]
  */
final case class FitResult(
    features: FitFeatures,
    budget: FitBudget,
    trained: Seq[(View, ViewErrors)],
    heldOut: Seq[(View, ViewErrors)],
    oneBitLess: Seq[(String, Double)]
) {
  val heldOutOver: Int = heldOut.count { case (_, e) => budget.share(e) > 1 }

  /** At most one of the views that took no part in the search is over. */
  def met: Boolean = heldOutOver <= 1

  /** Worst first. */
  def worst: Seq[(View, ViewErrors)] = (heldOut ++ trained).sortBy { case (_, e) => -budget.share(e) }

  /** What share of all views may be over, with a confidence of 95 %, when so many of so many were (Clopper and Pearson,
    * 1934).
    */
  def overAtMost: Double = {
    val n = heldOut.length
    def likely(p: Double) = (0 to heldOutOver).map { k =>
      (0 until k).map(i => (n - i).toDouble / (i + 1)).product * pow(p, k) * pow(1 - p, n - k)
    }.sum
    @annotation.tailrec
    def bisect(low: Double, high: Double): Double = {
      val p = (low + high) / 2
      if (high - low < 1e-6) p else if (likely(p) > 0.05) bisect(p, high) else bisect(low, p)
    }
    if (heldOutOver >= n) 1 else bisect(0, 1)
  }
}
