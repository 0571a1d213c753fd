package frustum.engine

import frustum.FragmentProbe
import frustum.host.{Driver, PreparedFrame}
import frustum.reference.raster.ReferenceRaster
import frustum.spec.{FramePass, RasterConfig}

/** The engine that a pass renderer makes. */
final class PassEngine(renderer: RasterConfig => PassRenderer) extends Engine {
  def render(frames: Seq[PreparedFrame]): Seq[RenderedFrame] = frames.map { frame =>
    val image  = new Array[Int](frame.config.width * frame.config.height)
    val memory = ReferenceRaster.texelMemory(frame.textures)
    frame.passes.foreach(renderer(frame.config).draw(_, memory, image, None))
    RenderedFrame(image, busBytes = Some(frame.passes.flatMap(Driver.commands).map(_.length.toLong).sum))
  }
}
