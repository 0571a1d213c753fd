package frustum.engine.raster

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.PreparedFrame
import frustum.engine.Engine
import frustum.model.raster.PassRenderer
import frustum.reference.raster.ReferenceRaster

/** The engine that a pass renderer makes. */
final class PassEngine(renderer: RasterConfig => PassRenderer) extends Engine[PreparedFrame, RenderedFrame] {
  def draw(frames: Iterator[PreparedFrame])(each: RenderedFrame => Unit): Unit = frames.foreach { frame =>
    val image = new Array[Int](frame.config.width * frame.config.height)
    val memory = ReferenceRaster.texelMemory(frame.textures)
    frame.passes.foreach(renderer(frame.config).draw(_, memory, image, None))
    each(RenderedFrame(image, busBytes = Some(PipelineEngine.busBytes(frame))))
  }
}
