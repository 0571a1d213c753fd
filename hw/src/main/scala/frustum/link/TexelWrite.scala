package frustum.link

import spinal.core._

/** A texel for texel memory, `address` in texels. */
case class TexelWrite() extends Bundle {
  val address = UInt(15 bits)
  val data    = Bits(16 bits)
}
