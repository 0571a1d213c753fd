package frustum.engine

import frustum.InputError
import frustum.spec.RasterConfig

/** An engine by name.
  *
  * @param simulated drives hardware: has clocks, may write a waveform, is held against the model
  */
final case class EngineEntry(name: String, simulated: Boolean, make: EngineOptions => Engine)

/** The engines there are, and the model that the judges run beside them. */
object Engines {

  /** Every name the command line knows, the default first; an engine that is not in [[table]] is refused. */
  val names: Seq[String] = Seq("hardware", "pipeline", "model", "reference")

  val table: Seq[EngineEntry] = Seq(
    EngineEntry("reference", simulated = false, _ => new PassEngine(new ReferenceRenderer(_)))
  )

  /** The bit-exact model, which tells its fragments; None while there is none. */
  val model: Option[RasterConfig => PassRenderer] = None

  def byName(name: String): EngineEntry = table.find(_.name == name).getOrElse(
    throw InputError(s"--engine: $name is not built yet; use one of ${table.map(_.name).mkString(", ")}")
  )
}
