package frustum.fit

/** What may be wrong at most, in each view. None: not asked for.
  *
  * @param texelsWrong     per cent of judged texels
  * @param primitivesWrong per cent of the screen's pixels, that show another triangle than they should
  * @param flip            mean FLIP between the picture and the reference's
  */
final case class FitBudget(texelsWrong: Double, primitivesWrong: Option[Double], flip: Option[Double]) {

  /** Greatest error as a share of its budget: 1 is just met. */
  def share(e: ViewErrors): Double = Seq(
    Some(FitBudget.share(e.texelsWrong, texelsWrong)),
    primitivesWrong.map(FitBudget.share(e.primitivesWrong, _)),
    for (bound <- flip; f <- e.flip) yield FitBudget.share(f, bound)
  ).flatten.max
}
object FitBudget {
  private def share(error: Double, bound: Double) = if (error == 0) 0.0 else error / bound
}

/** Errors of one view, in the units of [[FitBudget]]. */
final case class ViewErrors(texelsWrong: Double, primitivesWrong: Double, flip: Option[Double])
