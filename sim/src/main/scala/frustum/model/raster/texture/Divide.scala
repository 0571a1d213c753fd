package frustum.model.raster.texture

import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.raster.RasterConfig

/** Bit-exact perspective divide, one way or the other. */
trait Divide {

  /** Left shift that normalises q. */
  def exponent(q: Int): Int

  /** r = 2 - 1/qn with 16 fraction bits. */
  final def reciprocal(q: Int, exponent: Int): Int = ReciprocalTable(((q << exponent) >>> 10) & 0xfffff)

  /** The coordinate in repeats, 17 fraction bits. */
  def quotient(s: Int, exponent: Int, reciprocal: Int): Int

  final def apply(s: Int, q: Int): Int = {
    val e = exponent(q)
    quotient(s, e, reciprocal(q, e))
  }
}

object Divide {

  /** The one that hardware of this configuration has. */
  def of(config: RasterConfig): Divide =
    if (frustum.raster.texture.LateDivide.suits(config)) new LateDivide(config) else PerspectiveDivide
}
