package frustum.judge

/** What was found on frames of pong.
  *
  * @param pixelsDifferent at the pins, against the bit-exact model
  * @param rays            of the model's picture, before text and before it is reduced to the format at the pins
  */
final case class PongFigures(frames: Int, pixelsDifferent: Long, rays: RayCounts) {
  def +(o: PongFigures): PongFigures =
    PongFigures(frames + o.frames, pixelsDifferent + o.pixelsDifferent, rays + o.rays)

  /** What must be zero and is not. */
  def failures: Seq[String] = Seq(
    pixelsDifferent -> "pixels differ from the model's",
    rays.silhouettePixelsWrong -> "pixels of silhouettes are wrong",
    rays.shadowPixelsWrong -> "pixels of shadows are wrong",
    rays.objectPixelsWrong -> "pixels show the wrong object",
    rays.checkerCellsWrong -> "pixels show the wrong checker cell"
  ).collect { case (n, what) if n > 0 => s"$n $what" }
}

object PongFigures {
  val none: PongFigures = PongFigures(0, 0, RayCounts.none)
}
