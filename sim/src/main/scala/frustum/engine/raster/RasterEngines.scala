package frustum.engine.raster

import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.driver.raster.PreparedFrame
import frustum.engine.EngineKind._
import frustum.engine.{Engine, EngineEntry, EngineKind, EngineTable}
import frustum.model.raster.{PassRenderer, RasterModel}
import java.nio.file.Path

/** What an engine may be told.
  *
  * @param seed of whatever is random, such as stalls
  * @param wave file that takes the waveform of a simulated engine
  * @param panel display at the pins
  * @param live each work is taken when the frame before has been handed over, for works that depend on it
  */
final case class EngineOptions(
    seed: Long,
    wave: Option[Path],
    panel: Panel = Panel.Ili9341,
    live: Boolean = false
)

/** The engines of triangles, and the model that the judges run beside them. */
object RasterEngines
    extends EngineTable(
      new RasterEngineEntry("hardware", Board)(o => if (o.live) new PinsEngine(o) else new HardwareEngine(o)),
      new RasterEngineEntry("pipeline", Pipeline)(new PipelineEngine(_)),
      new RasterEngineEntry("model", Model)(_ => new PassEngine(new RasterModel(_))),
      new RasterEngineEntry("reference", Reference)(_ => new PassEngine(new ReferenceRenderer(_)))
    ) {

  /** The bit-exact model, which tells its fragments. */
  val model: Option[RasterConfig => PassRenderer] = Some(new RasterModel(_))
}

/** An engine of triangles by name. All frames of one call have the same textures too. */
final class RasterEngineEntry(name: String, kind: EngineKind)(
    make: EngineOptions => Engine[PreparedFrame, RenderedFrame]
) extends EngineEntry[EngineOptions, Engine[PreparedFrame, RenderedFrame]](name, kind)(make)
