package frustum.scene

import frustum.contract.arithmetic.IntVector
import frustum.contract.InputError
import java.nio.file.Path

/** Parts of a JSON file, each with the path to it: what is no such thing is refused in one line. */
class JsonFields(file: Path) {
  def refuse(path: String, what: String): Nothing = throw InputError(s"$file: $path: $what")

  def fields(v: ujson.Value, path: String, known: String*): collection.Map[String, ujson.Value] =
    v match {
      case o: ujson.Obj =>
        o.value.keys.find(!known.contains(_)).foreach(k =>
          refuse(path, s"there is no key '$k'; known are ${known.mkString(", ")}")
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
    case other => refuse(path, s"${ujson.write(other)} is not a whole number of at most 6 digits")
  }
  def vector(v: ujson.Value, path: String): IntVector = list(v, path) match {
    case Seq(x, y, z) => IntVector(whole(x, path), whole(y, path), whole(z, path))
    case other        => refuse(path, s"has ${other.size} numbers; write [x, y, z]")
  }
  def color(v: ujson.Value, path: String): Int = v match {
    case ujson.Str(s) if s.matches("[0-9a-fA-F]{6}") => Integer.parseInt(s, 16)
    case other                                       =>
      refuse(path, s"${ujson.write(other)} is no colour; write six hexadecimal digits, \"ff8000\"")
  }

  /** The vector or number of a key that must be there. */
  def need[A](
      o: collection.Map[String, ujson.Value],
      path: String,
      key: String
  )(read: (ujson.Value, String) => A): A =
    read(o.getOrElse(key, refuse(path, s"the key '$key' is missing")), s"$path.$key")
}
