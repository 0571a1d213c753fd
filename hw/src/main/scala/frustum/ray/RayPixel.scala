package frustum.ray

import spinal.core._
import spinal.lib.graphic.{Rgb, RgbConfig}

/** Colour, and what shows: 0 background, 1 wall, then the scene's quads, then its spheres. */
case class RayPixel() extends Bundle {
  val rgb = Rgb(RgbConfig(8, 8, 8))
  val objectId = UInt(4 bits)
}
