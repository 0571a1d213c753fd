package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.Domain
import scala.math.{ceil, log, pow}

/** Brings a frame's w into the declared domain. Clip coordinates are homogeneous: all of them times one power
  * of two draw the same picture, because only ratios of w matter.
  */
object WScale {

  /** The factor for a frame whose w lies in `low`..`high`; 1 where nothing is to be done. */
  def factor(low: Double, high: Double): Double = {
    def log2(x: Double) = log(x) / log(2)
    val exponent =
      if (high > Domain.MaxW) -ceil(log2(high / Domain.MaxW))
      else if (low < Domain.MinW) ceil(log2(Domain.MinW / low))
      else 0.0
    val scale = pow(2, exponent)
    if (!(low > 0) || !(low * scale >= Domain.MinW && high * scale <= Domain.MaxW))
      throw InputError(
        s"depths of $low to $high in one frame: the largest may be " +
          s"${(Domain.MaxW / Domain.MinW).toLong} times the smallest " +
          s"(w of ${Domain.MinW} to ${Domain.MaxW}); move the near plane out or the far plane in"
      )
    scale
  }
}
