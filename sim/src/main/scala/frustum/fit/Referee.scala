package frustum.fit

import frustum.judge.MesaJudge
import frustum.reference.raster.Mesa

/** Another renderer's judgement of an answer, on the views that took no part in the search.
  *
  * @param views,over            views judged, and those of them over the budget of texels or primitives
  * @param texelsWrong,primitivesWrong per cent, of the worst view each
  */
final case class Referee(views: Int, over: Int, texelsWrong: Double, primitivesWrong: Double) {
  def met: Boolean = over <= 1

  override def toString: String =
    if (views == 0) "llvmpipe judges nothing: there is an alpha test"
    else
      f"llvmpipe finds $over of $views views over, at worst $texelsWrong%.3f %% of the texels and $primitivesWrong%.3f %% of the pixels wrong"
}

object Referee {
  def apply(mesa: Mesa, fit: Fit, result: FitResult): Referee = {
    val found = for {
      (view, _) <- result.heldOut
      (frame, logs) = fit.draw(view, result.features.config.formats)
      v <- MesaJudge.judge(mesa, frame, logs)
    } yield ViewErrors(
      100.0 * v.wrong / v.judged.max(1),
      100.0 * v.primitiveWrong / (frame.config.width * frame.config.height),
      None
    )
    Referee(
      found.length,
      found.count(result.budget.share(_) > 1),
      found.map(_.texelsWrong).maxOption.getOrElse(0),
      found.map(_.primitivesWrong).maxOption.getOrElse(0)
    )
  }
}
