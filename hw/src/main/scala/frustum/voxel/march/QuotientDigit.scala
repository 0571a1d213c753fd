package frustum.voxel.march

import spinal.core._

/** A binary digit of a quotient by subtraction.
  *
  * @param rest what is left of the dividend, below twice `part`
  * @param part the divisor times the digit's weight
  */
class QuotientDigit(rest: UInt, part: UInt) {
  private val less = rest.resize(rest.getWidth + 1) - part.resize(rest.getWidth + 1)

  val digit: Bool = !less.msb

  /** The rest after this digit. */
  def left: UInt = Mux(less.msb, rest, less.resize(rest.getWidth))
}
