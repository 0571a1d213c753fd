package frustum.judge

/** What was found on frames of pong: faults are sums over frames, the colour error is the greatest of all.
  *
  * @param squaredError      of the picture before it is reduced to the format at the pins
  * @param pixelsDifferent   at the pins, against the bit-exact model
  */
final case class PongFigures(
    frames: Int = 0,
    pixels: Long = 0,
    silhouettePixelsWrong: Long = 0,
    shadowPixelsWrong: Long = 0,
    objectPixelsWrong: Long = 0,
    checkerCellsWrong: Long = 0,
    maxColourError: Double = 0,
    colourErrorsOver1: Long = 0,
    squaredError: Double = 0,
    pixelsDifferent: Long = 0
) {
  def +(o: PongFigures): PongFigures = PongFigures(
    frames + o.frames,
    pixels + o.pixels,
    silhouettePixelsWrong + o.silhouettePixelsWrong,
    shadowPixelsWrong + o.shadowPixelsWrong,
    objectPixelsWrong + o.objectPixelsWrong,
    checkerCellsWrong + o.checkerCellsWrong,
    maxColourError.max(o.maxColourError),
    colourErrorsOver1 + o.colourErrorsOver1,
    squaredError + o.squaredError,
    pixelsDifferent + o.pixelsDifferent
  )

  /** Decibels; None when every colour is the reference's. */
  def psnr: Option[Double] = Psnr.of(squaredError, pixels)

  /** What must be zero and is not. */
  def failures: Seq[String] = Seq(
    pixelsDifferent       -> "pixels differ from the model's",
    silhouettePixelsWrong -> "pixels of silhouettes are wrong",
    shadowPixelsWrong     -> "pixels of shadows are wrong",
    objectPixelsWrong     -> "pixels show the wrong object",
    checkerCellsWrong     -> "pixels show the wrong checker cell"
  ).collect { case (n, what) if n > 0 => s"$n $what" }
}

object PongFigures {

  /** Of one frame. */
  def apply(c: RayCounts, pixels: Int, pixelsDifferent: Int): PongFigures = PongFigures(
    1,
    pixels,
    c.silhouettePixelsWrong,
    c.shadowPixelsWrong,
    c.objectPixelsWrong,
    c.checkerCellsWrong,
    c.maxColourError,
    c.colourErrorsOver1,
    c.psnr.fold(0.0)(db => 255.0 * 255 * 3 * pixels / scala.math.pow(10, db / 10)),
    pixelsDifferent
  )
}
