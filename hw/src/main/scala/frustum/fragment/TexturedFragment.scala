package frustum.fragment

import frustum.spec.RasterConfig
import frustum.texture.Texel
import spinal.core._

/** A fragment with the texel at its coordinate. */
case class TexturedFragment(config: RasterConfig) extends Bundle {
  val attributes = FragmentAttributes(config)
  val texel      = Texel()
}
