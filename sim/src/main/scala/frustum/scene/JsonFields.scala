package frustum.scene

import frustum.contract.arithmetic.IntVector
import frustum.files.JsonDocument

/** Parts of a JSON file, each with the path to it: what is no such thing is refused in one line that names the part's
  * line and path.
  */
class JsonFields(document: JsonDocument) {

  def refuse(path: String, what: String): Nothing = refuse(path, what, path)

  /** @param at path of what gives the line, where that is a part of what is named */
  private def refuse(path: String, what: String, at: String): Nothing = document.refuse(at, s"${named(path)}: $what")

  /** A value for a message: long ones are cut. */
  def shown(v: ujson.Value): String = {
    val text = ujson.write(v)
    if (text.length > JsonFields.MostShown) text.take(JsonFields.MostShown) + "..." else text
  }

  def fields(v: ujson.Value, path: String, known: String*): collection.Map[String, ujson.Value] =
    v match {
      case o: ujson.Obj =>
        o.value.keys.find(!known.contains(_)).foreach(k =>
          refuse(path, s"there is no key '$k'; known are ${known.mkString(", ")}", inside(path, k))
        )
        o.value
      case _ => refuse(path, s"is no object; write {${known.map("\"" + _ + "\": ...").mkString(", ")}}")
    }
  def list(v: ujson.Value, path: String): Seq[ujson.Value] = v match {
    case a: ujson.Arr => a.value.toSeq
    case _            => refuse(path, "is no list; write [...]")
  }
  def whole(v: ujson.Value, path: String): Int = v match {
    case ujson.Num(n) if n == n.toInt && n.abs < 1e6 => n.toInt
    case other                                       =>
      refuse(path, s"${shown(other)} is not a whole number of at most 6 digits")
  }
  def vector(v: ujson.Value, path: String): IntVector = list(v, path) match {
    case Seq(x, y, z) => IntVector(whole(x, s"$path[0]"), whole(y, s"$path[1]"), whole(z, s"$path[2]"))
    case other        => refuse(path, s"has ${other.size} numbers; write [x, y, z]")
  }
  def color(v: ujson.Value, path: String): Int = v match {
    case ujson.Str(s) if s.matches("[0-9a-fA-F]{6}") => Integer.parseInt(s, 16)
    case other                                       =>
      refuse(path, s"${shown(other)} is no colour; write six hexadecimal digits, \"ff8000\"")
  }

  /** The value of a key that must be there. */
  def need[A](
      o: collection.Map[String, ujson.Value],
      path: String,
      key: String
  )(read: (ujson.Value, String) => A): A =
    read(o.getOrElse(key, refuse(path, s"the key '$key' is missing")), inside(path, key))

  /** The path of a key in an object. */
  def inside(path: String, key: String): String = if (path.isEmpty) key else s"$path.$key"

  /** What the part at a path is called in messages. */
  protected def named(path: String): String = if (path.isEmpty) "the file" else path
}

object JsonFields {
  private val MostShown = 60
}
