package frustum.raster.tile

import spinal.core._

/** Announces a frame or pass. Its fragments may follow when this is taken. */
case class FrameStart() extends Bundle {
  val clearColor = Bits(16 bits) // RGB565
}
