package frustum.model.raster.texture

import frustum.contract.raster.RasterConfig
import scala.math.min

/** Bit-exact perspective divide for triangles whose depths are near each other; see the hardware of the same name. */
final class LateDivide(config: RasterConfig) extends Divide {
  private val low = frustum.raster.texture.LateDivide.low(config)

  def exponent(q: Int): Int = min(Integer.numberOfLeadingZeros(q << 1), config.ranges.ratio)

  def quotient(s: Int, exponent: Int, reciprocal: Int): Int = {
    val product = (s >> low).toLong * ((1 << 17) - reciprocal) >> 15
    (product << (low + exponent) >> 7).toInt << 5 >> 5 // 27 bits
  }
}
