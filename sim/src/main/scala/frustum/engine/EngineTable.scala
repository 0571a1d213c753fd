package frustum.engine

/** What an engine is: bit-exact or not, and how much of the hardware takes part. */
sealed abstract class EngineKind(val simulated: Boolean = false, val atPins: Boolean = false)

object EngineKind {

  /** Float64, which no model is held against. */
  case object Reference extends EngineKind

  /** Bit-exact Scala. */
  case object Model extends EngineKind

  /** A pipeline in simulation: has cycles and signals, and is held against the model. */
  case object Pipeline extends EngineKind(simulated = true)

  /** A board's top in simulation, with a display at its pins. */
  case object Board extends EngineKind(simulated = true, atPins = true)
}

/** An engine by name.
  *
  * @param former a name that it had and still answers to
  */
class EngineEntry[-Setting, +E](val name: String, val kind: EngineKind, val former: Option[String] = None)(
    val make: Setting => E
)

/** The engines of one kind of scene, the default first. */
class EngineTable[Entry <: EngineEntry[Nothing, Any]](val entries: Entry*) {
  def default: Entry = entries.head
  def names: Seq[String] = entries.map(_.name)
  def find(name: String): Option[Entry] = entries.find(e => e.name == name || e.former.contains(name))

  /** @throws IllegalArgumentException telling the names that there are */
  def byName(name: String): Entry =
    find(name).getOrElse(throw new IllegalArgumentException(s"'$name' is none of ${names.mkString(", ")}"))
}
