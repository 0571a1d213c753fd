package frustum.judge

/** Differences of frames from the exact picture; a pixel is seen as an object and a colour. Faults are sums, the colour
  * error is the greatest of all.
  */
final case class RayCounts(
    pixels: Long,
    silhouettePixelsWrong: Long,
    shadowPixelsWrong: Long,
    objectPixelsWrong: Long,
    checkerCellsWrong: Long,
    maxColourError: Double,
    colourErrorsOver1: Long,
    squaredError: Double
) {

  /** Decibels; None when every colour is the exact one. */
  def psnr: Option[Double] = Psnr.of(squaredError, pixels)

  def +(o: RayCounts): RayCounts = RayCounts(
    pixels + o.pixels,
    silhouettePixelsWrong + o.silhouettePixelsWrong,
    shadowPixelsWrong + o.shadowPixelsWrong,
    objectPixelsWrong + o.objectPixelsWrong,
    checkerCellsWrong + o.checkerCellsWrong,
    maxColourError.max(o.maxColourError),
    colourErrorsOver1 + o.colourErrorsOver1,
    squaredError + o.squaredError
  )
}

object RayCounts {
  val none: RayCounts = RayCounts(0, 0, 0, 0, 0, 0, 0, 0)
}
