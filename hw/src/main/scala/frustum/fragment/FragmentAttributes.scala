package frustum.fragment

import frustum.raster.InterpolatedFragment
import frustum.spec.RasterConfig
import spinal.core._

/** What a fragment carries beside its texture coordinate: place in the tile, depth 0..65535, colour 0..255.
  */
case class FragmentAttributes(config: RasterConfig) extends Bundle {
  val x = UInt(config.tileLog2Width bits)
  val y = UInt(config.tileLog2Height bits)
  val z = UInt(16 bits)
  val r, g, b, a = UInt(8 bits)
  val tileEnd = Bool()
}

object FragmentAttributes {

  /** Fraction bits cut, values outside clamped. The top two bits tell on which side a value left its range,
    * because it leaves it by less than one unit: 11 is below zero, 10 has overflowed.
    */
  def apply(config: RasterConfig, from: InterpolatedFragment): FragmentAttributes = {
    val attributes = FragmentAttributes(config)
    def clamped(v: SInt, bits: Int) = {
      val sign = v.msb
      val upper = v(v.high - 1)
      (v(v.high - 1 downto v.high - bits).asBits | (sign && !upper) #* bits) & ~((sign && upper) #* bits)
    }
    attributes.x := from.x
    attributes.y := from.y
    attributes.z := clamped(from.z, 16).asUInt
    attributes.r := clamped(from.r, 8).asUInt
    attributes.g := clamped(from.g, 8).asUInt
    attributes.b := clamped(from.b, 8).asUInt
    attributes.a := clamped(from.a, 8).asUInt
    attributes.tileEnd := from.tileEnd
    attributes
  }
}
