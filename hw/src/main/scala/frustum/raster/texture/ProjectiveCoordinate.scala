package frustum.raster.texture

import spinal.core._

/** Texture coordinate before the perspective divide, as the interpolator gives it: s/w and t/w with 23
  * fraction bits, 1/w with 31, all three scaled alike.
  */
case class ProjectiveCoordinate() extends Bundle {
  val s, t, q = SInt(32 bits)
}
