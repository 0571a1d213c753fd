package frustum.scene

import frustum.{InputError, JsonFile}
import frustum.spec._
import java.nio.file.Path

/** A ray-cast scene as JSON. Every key may be left out and is then that of `base`:
  *
  *   - `camera`: `{"eye": [x, y, z], "focal": n}`, looking along +z with `focal` pixels to the screen plane; or
  *     `{"eye", "corner", "right", "down"}`, vectors of the ray of pixel (h, v): corner + h right + v down
  *   - `room`: `{"low": [x, y, z], "high": [x, y, z], "cellBits": n}`, checker cells of 2^n units
  *   - `spheres`: each `{"low", "high", "radius", "color"}`, its centre staying between low and high; or `"centre"`
  *   - `quads`: each `{"low", "high", "half", "color"}` or with `"centre"`, squares on the back wall
  *   - `light`: `[x, y, z]`, or `null`; `background`: a colour
  *
  * Coordinates are whole units; colours are strings of six hexadecimal digits. Keys that are not known are errors.
  */
object RaySceneFile {

  /** @param width,height of the picture, for the camera */
  def read(file: Path, base: RayScene, width: Int, height: Int): RayScene = {
    val root = JsonFile.read(file, "docs/pong.md")
    try new Reader(file).scene(root, base, width, height)
    catch {
      case e: IllegalArgumentException =>
        throw InputError(s"$file: ${e.getMessage.stripPrefix("requirement failed: ")}")
    }
  }

  private class Reader(file: Path) {
    private def refuse(path: String, what: String): Nothing = throw InputError(s"$file: $path: $what")

    private def fields(v: ujson.Value, path: String, known: String*): collection.Map[String, ujson.Value] =
      v match {
        case o: ujson.Obj =>
          o.value.keys.find(!known.contains(_)).foreach(k =>
            refuse(path, s"there is no key '$k'; known are ${known.mkString(", ")}")
          )
          o.value
        case _ => refuse(path, s"is no object; write {${known.map("\"" + _ + "\": ...").mkString(", ")}}")
      }
    private def list(v: ujson.Value, path: String): Seq[ujson.Value] = v match {
      case a: ujson.Arr => a.value.toSeq
      case _            => refuse(path, "is no list; write [...]")
    }
    private def whole(v: ujson.Value, path: String): Int = v match {
      case ujson.Num(n) if n == n.toInt && n.abs < 1e6 => n.toInt
      case other => refuse(path, s"${ujson.write(other)} is not a whole number of at most 6 digits")
    }
    private def vector(v: ujson.Value, path: String): IntVector = list(v, path) match {
      case Seq(x, y, z) => IntVector(whole(x, path), whole(y, path), whole(z, path))
      case other        => refuse(path, s"has ${other.size} numbers; write [x, y, z]")
    }
    private def color(v: ujson.Value, path: String): Int = v match {
      case ujson.Str(s) if s.matches("[0-9a-fA-F]{6}") => Integer.parseInt(s, 16)
      case other                                       =>
        refuse(path, s"${ujson.write(other)} is no colour; write six hexadecimal digits, \"ff8000\"")
    }

    /** The vector or number of a key that must be there. */
    private def need[A](
        o: collection.Map[String, ujson.Value],
        path: String,
        key: String
    )(read: (ujson.Value, String) => A): A =
      read(o.getOrElse(key, refuse(path, s"the key '$key' is missing")), s"$path.$key")

    private def range(o: collection.Map[String, ujson.Value], path: String): (IntVector, IntVector) =
      if (o.contains("centre")) {
        val c = need(o, path, "centre")(vector)
        if (o.contains("low") || o.contains("high"))
          refuse(path, "has a centre and low or high; give one of them")
        (c, c)
      } else (need(o, path, "low")(vector), need(o, path, "high")(vector))

    private def camera(v: ujson.Value, width: Int, height: Int): RayCamera = {
      val o   = fields(v, "camera", "eye", "focal", "corner", "right", "down")
      val eye = need(o, "camera", "eye")(vector)
      if (o.contains("focal")) RayCamera.forward(eye, width, height, need(o, "camera", "focal")(whole))
      else RayCamera(
        eye,
        need(o, "camera", "corner")(vector),
        need(o, "camera", "right")(vector),
        need(o, "camera", "down")(vector)
      )
    }

    private def room(v: ujson.Value): RayRoom = {
      val o = fields(v, "room", "low", "high", "cellBits")
      RayRoom(
        need(o, "room", "low")(vector),
        need(o, "room", "high")(vector),
        need(o, "room", "cellBits")(whole)
      )
    }

    private def sphere(v: ujson.Value, path: String): RaySphere = {
      val o           = fields(v, path, "low", "high", "centre", "radius", "color")
      val (low, high) = range(o, path)
      RaySphere(low, high, need(o, path, "radius")(whole), need(o, path, "color")(color))
    }

    private def quad(v: ujson.Value, path: String): RayQuad = {
      val o           = fields(v, path, "low", "high", "centre", "half", "color")
      val (low, high) = range(o, path)
      RayQuad(low, high, need(o, path, "half")(whole), need(o, path, "color")(color))
    }

    private def each[A](v: ujson.Value, path: String)(read: (ujson.Value, String) => A): Seq[A] =
      list(v, path).zipWithIndex.map { case (e, i) => read(e, s"$path[$i]") }

    def scene(root: ujson.Value, base: RayScene, width: Int, height: Int): RayScene = {
      val o = fields(root, "scene", "camera", "room", "spheres", "quads", "light", "background")
      RayScene(
        o.get("camera").fold(base.camera)(camera(_, width, height)),
        o.get("room").fold(base.room)(room),
        o.get("spheres").fold(base.spheres)(each(_, "spheres")(sphere)),
        o.get("quads").fold(base.quads)(each(_, "quads")(quad)),
        o.get("light").fold(base.light)(v => if (v.isNull) None else Some(vector(v, "light"))),
        o.get("background").fold(base.background)(color(_, "background"))
      )
    }
  }
}
