package frustum.raster.texture

import spinal.core._

/** One 16-bit texel for texel memory. */
case class TexelWrite() extends Bundle {
  val address = UInt(15 bits)
  val data = Bits(16 bits)
}
