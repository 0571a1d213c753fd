package frustum.model.texture

import frustum.spec.ReciprocalTable

/** Bit-exact perspective divide; see the hardware of the same name for the formats. */
object PerspectiveDivide {

  /** Left shift that normalises q, 0..15. */
  def exponent(q: Int): Int = Integer.numberOfLeadingZeros((q << 1) | (1 << 16))

  /** r = 2 - 1/qn with 16 fraction bits. */
  def reciprocal(q: Int, exponent: Int): Int = ReciprocalTable(((q << exponent) >>> 10) & 0xfffff)

  /** The coordinate in repeats, 17 fraction bits. */
  def quotient(s: Int, exponent: Int, reciprocal: Int): Int = {
    val sn = (s << exponent) >> 1 | 15
    val product = (sn >> 16) * reciprocal + (((sn & 0xffff) * reciprocal) >>> 16)
    (2 * sn - product - 1) >> 5
  }

  def apply(s: Int, q: Int): Int = {
    val e = exponent(q)
    quotient(s, e, reciprocal(q, e))
  }
}
