package frustum.fit

import frustum.judge.{EndToEndJudge, MesaJudge}
import frustum.referee.{EndToEnd, Llvmpipe, WorldPicture}
import frustum.reference.raster.Mesa

/** Another renderer's judgement of an answer, on the views that took no part in the search.
  *
  * @param views,over            views judged, and those of them over the budget of texels or primitives
  * @param texelsWrong,primitivesWrong per cent, of the worst view each
  * @param fromWorld             the same of pictures drawn from the world, of which neither driver nor snapping is part
  */
final case class Referee(
    views: Int,
    over: Int,
    texelsWrong: Double,
    primitivesWrong: Double,
    fromWorld: Option[Referee] = None
) {
  def met: Boolean = over <= 1 && fromWorld.forall(_.met)

  private def figures =
    f"$over of $views views over, at worst $texelsWrong%.3f %% of the texels and $primitivesWrong%.3f %% of the " +
      "pixels wrong"

  override def toString: String =
    (if (views == 0) "llvmpipe judges nothing of the driver's triangles: there is an alpha test"
     else s"llvmpipe finds $figures") +
      fromWorld.fold("")(w => s"; from the world ${w.figures}")
}

object Referee {
  def apply(mesa: Mesa, fit: Fit, result: FitResult): Referee = {
    val drawn = result.heldOut.map { case (view, _) => view -> fit.drawn(view, result.features.config.formats) }
    val own = drawn.flatMap { case (_, d) =>
      MesaJudge.judge(mesa, d.frame, d.logs).map(v =>
        errors(d, v.wrong, v.judged, v.primitiveWrong)
      )
    }
    val world = drawn.flatMap { case (view, d) =>
      val asked = fit.asked(view)
      Llvmpipe.draw(asked).map { m =>
        val v = EndToEnd.judge(new WorldPicture(asked), Some(m.seen), EndToEndJudge.seen(d.frame, d.logs), d.picture)
        errors(d, v.texelsUnexplained, v.judged, v.primitiveUnexplained)
      }
    }
    of(result, own).copy(fromWorld = Option.when(world.nonEmpty)(of(result, world)))
  }

  private def errors(d: DrawnView, texels: Long, judged: Long, primitives: Long) = ViewErrors(
    100.0 * texels / judged.max(1),
    100.0 * primitives / (d.frame.config.width * d.frame.config.height),
    None
  )

  private def of(result: FitResult, found: Seq[ViewErrors]) = Referee(
    found.length,
    found.count(result.budget.share(_) > 1),
    found.map(_.texelsWrong).maxOption.getOrElse(0),
    found.map(_.primitivesWrong).maxOption.getOrElse(0)
  )
}
