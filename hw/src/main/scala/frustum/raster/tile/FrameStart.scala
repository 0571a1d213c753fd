package frustum.raster.tile

import spinal.core._

/** Announces a frame or pass. Its fragments may follow once this was taken. */
case class FrameStart() extends Bundle {
  val clearColor = Bits(16 bits) // RGB565
}
