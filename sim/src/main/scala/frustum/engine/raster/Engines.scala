package frustum.engine.raster

import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.model.raster.{PassRenderer, RasterModel}

/** An engine by name.
  *
  * @param simulated drives hardware: has clocks, may write a waveform, is held against the model
  * @param atPins    drives a board's top, with a display
  */
final case class EngineEntry(name: String, simulated: Boolean, make: EngineOptions => Engine, atPins: Boolean = false)

/** The engines there are, and the model that the judges run beside them. */
object Engines {

  /** Every name the command line knows, the default first; an engine that is not in [[table]] is refused. */
  val names: Seq[String] = Seq("hardware", "pipeline", "model", "reference")

  val table: Seq[EngineEntry] = Seq(
    EngineEntry("hardware", simulated = true, new HardwareEngine(_), atPins = true),
    EngineEntry("pipeline", simulated = true, new PipelineEngine(_)),
    EngineEntry("model", simulated = false, _ => new PassEngine(new RasterModel(_))),
    EngineEntry("reference", simulated = false, _ => new PassEngine(new ReferenceRenderer(_)))
  )

  /** The bit-exact model, which tells its fragments. */
  val model: Option[RasterConfig => PassRenderer] = Some(new RasterModel(_))

  def byName(name: String): EngineEntry = table.find(_.name == name).getOrElse(
    throw InputError(s"--engine: $name is not built yet; choose one of ${table.map(_.name).mkString(", ")}")
  )
}
