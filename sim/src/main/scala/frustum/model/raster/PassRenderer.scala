package frustum.model.raster

import frustum.contract.raster.{FramePass, RasterConfig}
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.reference.raster.ReferenceRaster

/** Draws one pass and tells the probe of each fragment: what the judges need of a model. */
trait PassRenderer {

  /** @param memory texel memory, 32768 texels
    * @param into   RGB565, row by row from the top left; only the pass's region is written
    */
  def draw(pass: FramePass, memory: Array[Int], into: Array[Int], probe: Option[FragmentProbe]): Unit
}
