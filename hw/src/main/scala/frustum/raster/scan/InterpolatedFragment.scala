package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._

/** What the interpolator gives to the fragment stages, one per cycle: a pixel of the current tile with its attributes,
  * or the tile-end marker.
  *
  *   - `s`, `t`: s/w and t/w, 23 fractional bits; `q`: 1/w scaled so that the triangle's largest lies in 0.5..1,
  *     31 fractional bits; texture coordinate in repeats = s / q
  *   - `z`: depth 0..65535 with 15 fractional bits; may leave that range by less than one unit
  *   - `r g b a`: 0..255 with 7 fractional bits; may leave that range by less than one unit
  *   - `tileEnd`: no pixel; every fragment of the tile came before
  */
case class InterpolatedFragment(config: RasterConfig) extends Bundle {
  val x = UInt(config.tileLog2Width bits)
  val y = UInt(config.tileLog2Height bits)
  val s, t, q, z = SInt(32 bits)
  val r, g, b, a = SInt(16 bits)
  val tileEnd = Bool()
}
