package frustum.raster.texture

import spinal.core._

/** Texture coordinate in repeats, 17 fraction bits, -512 to 512. */
case class TextureCoordinate() extends Bundle {
  val s, t = SInt(TextureCoordinate.Width bits)
}

object TextureCoordinate {
  val Width = 27
  val FractionBits = 17
}
