package frustum.model.raster.texture

/** Bit-exact perspective divide; see the hardware of the same name for the formats. */
object PerspectiveDivide extends Divide {

  /** 0..15. */
  def exponent(q: Int): Int = Integer.numberOfLeadingZeros((q << 1) | (1 << 16))

  def quotient(s: Int, exponent: Int, reciprocal: Int): Int = {
    val sn = (s << exponent) >> 1 | 15
    val product = (sn >> 16) * reciprocal + (((sn & 0xffff) * reciprocal) >>> 16)
    (2 * sn - product - 1) >> 5
  }
}
