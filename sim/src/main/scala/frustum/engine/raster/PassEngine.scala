package frustum.engine.raster

import frustum.contract.raster.{FramePass, RasterConfig}
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.model.raster.{FragmentProbe, PassRenderer}
import frustum.reference.raster.ReferenceRaster

/** The engine that a pass renderer makes. */
final class PassEngine(renderer: RasterConfig => PassRenderer) extends Engine {
  def render(frames: Seq[PreparedFrame]): Seq[RenderedFrame] = frames.map { frame =>
    val image = new Array[Int](frame.config.width * frame.config.height)
    val memory = ReferenceRaster.texelMemory(frame.textures)
    frame.passes.foreach(renderer(frame.config).draw(_, memory, image, None))
    RenderedFrame(image, busBytes = Some(frame.passes.flatMap(Driver.commands).map(_.length.toLong).sum))
  }
}
