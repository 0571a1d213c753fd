package frustum.engine.raster

import frustum.contract.raster.{FramePass, RasterConfig}
import frustum.model.raster.{FragmentProbe, PassRenderer}
import frustum.reference.raster.{PixelRect, ReferenceFrame, ReferenceRaster}

/** The float64 reference as a pass renderer; its picture rounded to RGB565, the depths it tells rounded to
  * nearest.
  */
final class ReferenceRenderer(config: RasterConfig) extends PassRenderer {
  def draw(pass: FramePass, memory: Array[Int], into: Array[Int], probe: Option[FragmentProbe]): Unit = {
    val target = new ReferenceFrame(config)
    ReferenceRaster.drawPass(
      target,
      pass,
      memory,
      0,
      f => {
        val (s, t) = f.texel.getOrElse((0, 0))
        probe.foreach(_.fragment(f.triangle, f.x, f.y, s, t, f.at.z.round.toInt.max(0).min(65535), f.drawn))
      }
    )
    val (drawn, rect) = (target.rgb565, PixelRect.of(pass.region, config))
    for (y <- rect.y0 to rect.y1)
      Array.copy(drawn, y * config.width + rect.x0, into, y * config.width + rect.x0, rect.x1 - rect.x0 + 1)
  }
}
