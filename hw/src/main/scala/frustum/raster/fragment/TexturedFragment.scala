package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.raster.texture.Texel
import spinal.core._

/** A fragment with the texel at its coordinate. */
case class TexturedFragment(config: RasterConfig) extends Bundle {
  val attributes = FragmentAttributes(config)
  val texel = Texel()
}
