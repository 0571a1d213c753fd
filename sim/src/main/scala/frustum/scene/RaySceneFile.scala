package frustum.scene

import frustum.contract.arithmetic.IntVector
import frustum.contract.InputError
import frustum.contract.ray.{
  RayCamera,
  RayCameraRange,
  RayChecker,
  RayImage,
  RayPaint,
  RayQuad,
  RayRoom,
  RayScene,
  RaySolid,
  RaySphere
}
import frustum.files.{JsonDocument, JsonFile}
import java.nio.file.Path

/** A ray-cast scene as JSON. Every key may be left out and is then that of `base`:
  *
  *   - `camera`: `{"eye": [x, y, z], "focal": n}`, looking along +z with `focal` pixels to the screen plane; or
  *     `{"eye", "corner", "right", "down"}`, vectors of the ray of pixel (h, v): corner + h right + v down; or, for one
  *     that moves, `{"low": {four vectors}, "high": {four vectors}, "lengths": [least, greatest]}` with the lengths of
  *     its rays
  *   - `room`: `{"low": [x, y, z], "high": [x, y, z], "cellBits": n}`, checker cells of 2^n units; with `"walls"`, any
  *     of `"left", "right", "floor", "ceiling", "back"`, each painted otherwise: `{"cellBits": n}`, `{"color": c}`, or
  *     `{"image": "FILE.png", "texelBits": n}`, nearest texels of 2^n units, sides that are powers of two, the file
  *     beside this one
  *   - `spheres`: each `{"low", "high", "radius", "color"}`, its centre staying between low and high; or `"centre"`
  *   - `quads`: each `{"low", "high", "half", "color"}` or with `"centre"`, squares on the back wall; `"image"` and
  *     `"texelBits"` for `"color"`
  *   - `light`: `[x, y, z]`, or `null`; `background`: a colour
  *
  * Coordinates are whole units; colours are strings of six hexadecimal digits. Keys that are not known are errors.
  */
object RaySceneFile {

  /** @param width,height of the picture, for the camera */
  def read(file: Path, base: RayScene, width: Int, height: Int): RayScene = {
    val document = JsonFile.read(file, "docs/pong.md")
    try new Reader(document, base).scene(document.root, width, height)
    catch {
      case e: IllegalArgumentException =>
        throw InputError(s"$file: ${e.getMessage.stripPrefix("requirement failed: ")}")
    }
  }

  /** Names of the walls, in the order of [[Wall.all]]. */
  private val Walls = Seq("left", "right", "floor", "ceiling", "back")

  private class Reader(document: JsonDocument, base: RayScene) extends JsonFields(document) {
    import RayCameraRange.Vectors
    override protected def named(path: String): String = if (path.isEmpty) "scene" else path

    private def range(o: collection.Map[String, ujson.Value], path: String): (IntVector, IntVector) =
      if (o.contains("centre")) {
        val c = need(o, path, "centre")(vector)
        if (o.contains("low") || o.contains("high"))
          refuse(path, "has a centre and low or high; give one of them")
        (c, c)
      } else (need(o, path, "low")(vector), need(o, path, "high")(vector))

    private def camera(v: ujson.Value, width: Int, height: Int): RayCameraRange = {
      val o = fields(v, "camera", "eye" +: "focal" +: "low" +: "high" +: "lengths" +: Vectors.tail: _*)
      if (o.contains("lengths"))
        each(o("lengths"), "camera.lengths")(whole) match {
          case Seq(least, most) =>
            val Seq(low, high) =
              Seq("low", "high").map(k =>
                need(o, "camera", k)((c, path) => vectors(fields(c, path, Vectors: _*), path))
              )
            RayCameraRange(low, high, Some((least, most)))
          case other => refuse("camera.lengths", s"has ${other.size} numbers; write [least, greatest]")
        }
      else if (o.contains("low") || o.contains("high")) need(o, "camera", "lengths")((_, _) => base.camera)
      else if (o.contains("focal"))
        RayCameraRange(RayCamera.forward(
          need(o, "camera", "eye")(vector),
          width,
          height,
          need(o, "camera", "focal")((v, path) =>
            whole(v, path) match {
              case n if n > 0 => n
              case n          => refuse(path, s"$n is no distance to the screen: at least 1")
            }
          )
        ))
      else RayCameraRange(vectors(o, "camera"))
    }
    private def vectors(o: collection.Map[String, ujson.Value], path: String): RayCamera = {
      val Seq(eye, corner, right, down) = Vectors.map(need(o, path, _)(vector))
      RayCamera(eye, corner, right, down)
    }

    private def room(v: ujson.Value): RayRoom = {
      val o = fields(v, "room", "low", "high", "cellBits", "walls")
      val all = RayRoom(
        need(o, "room", "low")(vector),
        need(o, "room", "high")(vector),
        need(o, "room", "cellBits")(whole)
      )
      val walls =
        o.get("walls").fold(collection.Map[String, ujson.Value]())(fields(_, "room.walls", Walls: _*))
      all.copy(paints = all.paints.zip(Walls).map { case (checker, name) =>
        walls.get(name).fold(checker)(paint(_, s"room.walls.$name"))
      })
    }

    private def paint(v: ujson.Value, path: String): RayPaint = {
      val o = fields(v, path, "cellBits", "color", "image", "texelBits")
      if (o.contains("cellBits")) RayChecker(need(o, path, "cellBits")(whole)) else surface(o, path)
    }

    /** What a wall or a quad may have. */
    private def surface(o: collection.Map[String, ujson.Value], path: String): RayPaint = {
      if (o.contains("image") && o.contains("color"))
        refuse(path, "has an image and a colour; give one of them")
      if (o.contains("image")) image(o, path) else RaySolid(need(o, path, "color")(color))
    }

    private def image(o: collection.Map[String, ujson.Value], path: String): RayImage = {
      val name = need(o, path, "image") {
        case (ujson.Str(s), _) => s
        case (other, at)       => refuse(at, s"${shown(other)} is no name of a file")
      }
      val picture =
        try TextureFile.read(
            document.file.resolveSibling(name),
            fault = (w, h) =>
              Option.when(!Seq(w, h).forall(n => n <= RayPaint.MaxSide && Integer.bitCount(n) == 1))(
                s"is $w x $h: each side must be a power of two up to ${RayPaint.MaxSide}"
              )
          )
        catch { case InputError(message) => refuse(inside(path, "image"), message) }
      RayImage(
        picture.width,
        picture.height,
        need(o, path, "texelBits")(whole),
        picture.argb.map(_ & 0xffffff)
      )
    }

    private def sphere(v: ujson.Value, path: String): RaySphere = {
      val o = fields(v, path, "low", "high", "centre", "radius", "color")
      val (low, high) = range(o, path)
      RaySphere(low, high, need(o, path, "radius")(whole), need(o, path, "color")(color))
    }

    private def quad(v: ujson.Value, path: String): RayQuad = {
      val o = fields(v, path, "low", "high", "centre", "half", "color", "image", "texelBits")
      val (low, high) = range(o, path)
      RayQuad(low, high, need(o, path, "half")(whole), surface(o, path))
    }

    private def each[A](v: ujson.Value, path: String)(read: (ujson.Value, String) => A): Seq[A] =
      list(v, path).zipWithIndex.map { case (e, i) => read(e, s"$path[$i]") }

    def scene(root: ujson.Value, width: Int, height: Int): RayScene = {
      val o = fields(root, "", "camera", "room", "spheres", "quads", "light", "background")
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
