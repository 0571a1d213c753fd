package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Slope of one of a ray's other axes against its fast one, from magnitudes of the direction's components:
  * {{{|other| / |fast| = v (1 - r / 2)}}} with 1 + f the mantissa of |fast|, v the other one to its scale, and
  * r = 2 f / (1 + f) of [[frustum.contract.arithmetic.ReciprocalTable]]; cut to `slopeBits` and below 1. Error below
  * 2.5 2^-15.
  */
object RaySlope {

  /** Bits of a component's magnitude; the greatest of a direction has one of the upper two set. */
  val MagnitudeBits: Int = frustum.contract.voxel.VoxelCamera.DirectionWidth - 1

  /** f, 20 fraction bits. */
  def mantissa(fast: UInt): UInt = Mux(half(fast), fast(20 downto 1), fast(21 downto 2))

  /** v, 16 bits, of which 15 are fraction bits. */
  def scaled(other: UInt, fast: UInt): UInt = Mux(half(fast), other(21 downto 6), other(22 downto 7))

  /** The slope, from v and the product of v and r. */
  def apply(config: VoxelConfig, scaled: UInt, product: Bits): UInt = {
    val quotient = scaled - product(31 downto 17).asUInt
    Mux(quotient.msb, U(0x7fff, 15 bits), quotient(14 downto 0)) >> 15 - config.slopeBits
  }

  /** A component below 1. */
  private def half(fast: UInt) = !fast.msb
}
