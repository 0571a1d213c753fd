package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.raster.scan.InterpolatedFragment
import spinal.core._

/** Attributes of a fragment other than texture coordinate and depth: place in the tile and colour. Colours are 0..255
  * when their top bit is clear; otherwise bit 7 is the side on which they left that range, as [[InterpolatedFragment]]
  * has it: set below 0, clear above 255.
  */
case class FragmentAttributes(config: RasterConfig) extends Bundle {
  val x = UInt(config.tileLog2Width bits)
  val y = UInt(config.tileLog2Height bits)
  val r, g, b, a = UInt(9 bits)
  val tileEnd = Bool()
}

object FragmentAttributes {

  /** Fraction bits cut; the range is left to the stage that has a register with reset for it. */
  def apply(config: RasterConfig, from: InterpolatedFragment): FragmentAttributes = {
    val attributes = FragmentAttributes(config)
    attributes.x := from.x
    attributes.y := from.y
    for (
      (to, value) <- Seq(
        attributes.r -> from.r,
        attributes.g -> from.g,
        attributes.b -> from.b,
        attributes.a -> from.a
      )
    ) to := value.takeHigh(9).asUInt
    attributes.tileEnd := from.tileEnd
    attributes
  }

  /** Depth 0..65535, clamped. The top two bits are the side on which a value left its range, because it leaves it by
    * less than one unit: 11 is below zero, 10 has overflowed.
    */
  def depth(z: SInt): UInt = {
    val below = z.msb && z(z.high - 1)
    val above = z.msb && !z(z.high - 1)
    ((z(z.high - 1 downto z.high - 16).asBits | above #* 16) & ~(below #* 16)).asUInt
  }
}
