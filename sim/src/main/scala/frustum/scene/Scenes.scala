package frustum.scene

import frustum.contract.InputError
import frustum.contract.raster.Combine
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Camera, Material, Scene}
import scala.math.{cos, max, pow, sin, toRadians}

/** The scenes made in code: nothing to load, the same everywhere. Each has the camera it is meant to be seen
  * with.
  */
object Scenes {
  val names: Seq[String] = Seq("teapot", "cube", "floor", "corridor", "terrain")

  /** A scene by its name; InputError names the scenes there are. */
  def byName(name: String): Scene = name match {
    case "teapot"   => teapot()
    case "cube"     => cube
    case "floor"    => floor
    case "corridor" => Corridor.scene
    case "terrain"  => Terrain.scene
    case _          => throw InputError(s"there is no scene '$name'; choose one of ${names.mkString(", ")}")
  }

  /** The Utah teapot in glazed earthenware: light and gloss are in the vertex colours, so that it needs no
    * light.
    *
    * @param tessellation
    *   steps of a quarter turn; 6 makes fewer than 1,000 triangles: one pass
    */
  def teapot(tessellation: Int = 6): Scene = {
    require(tessellation >= 1 && tessellation <= 64, s"tessellation $tessellation is outside 1..64")
    val eye = Vector3(4.2, 4.8, 9.3)
    val key = Vector3(0.55, 0.75, 0.45).normalized
    val fill = Vector3(-0.8, 0.1, 0.5).normalized
    val gloss = (eye.normalized + key).normalized
    def color(n: Vector3) = {
      val (k, f) = (max(0.0, n.dot(key)), max(0.0, n.dot(fill)))
      val shine = 0.55 * pow(max(0.0, n.dot(gloss)), 40)
      def channel(base: Double, warm: Double, cool: Double) =
        (base * (0.16 + 0.06 * n.y + warm * k + cool * f) + shine).min(1.0)
      (channel(0.86, 0.86, 0.12), channel(0.42, 0.80, 0.20), channel(0.22, 0.66, 0.42), 1.0)
    }
    val material = Material("glaze", (1, 1, 1), 1, None, Combine.ColorOnly, blend = false, None)
    val camera = Camera(eye, Vector3(0.42, 1.45, 0), Vector3(0, 1, 0), 45, 1, 40)
    Scene("teapot", Teapot.triangles(tessellation, color), IndexedSeq(material), camera, 0x1c2430)
  }

  /** A unit cube with one 64 x 64 texture on every face, seen from above; about half of 240 x 320. */
  def cube: Scene = {
    val faces = for (axis <- 0 to 2; sign <- Seq(1, -1)) yield {
      def unit(a: Int, v: Double) = Vector3.Axes(a) * v
      // right and up of the face as seen from outside, so that the picture stands upright on the four sides
      val normal = unit(axis, sign)
      val up = if (axis == 1) unit(2, -sign) else unit(1, 1)
      val right = up.cross(normal)
      val corner = (normal - up - right) * 0.5
      Grid.rectangle(corner, right, up, (1, 1), (1, 1), 0)(_ => (1, 1, 1, 1))
    }
    val (turn, elevation, distance) = (toRadians(30), toRadians(39), 3.9)
    val eye =
      Vector3(sin(turn) * cos(elevation), sin(elevation), cos(turn) * cos(elevation)) * distance
    val material = Material("crate", (1, 1, 1), 1, Some(Pictures.crate), Combine.Replace, blend = false, None)
    val camera = Camera(eye, Vector3.Zero, Vector3(0, 1, 0), 30, 1, 10)
    Scene("cube", faces.flatten, IndexedSeq(material), camera, 0x203048)
  }

  /** A floor to the horizon in two triangles, the texture repeated 8 times in both directions: the hardest
    * case for perspective. Numbers as in the figures it is compared by.
    */
  def floor: Scene = {
    val material =
      Material("checker", (1, 1, 1), 1, Some(Pictures.checker), Combine.Replace, blend = false, None)
    val quad = Grid.rectangle(
      Vector3(-50, -1, -1),
      Vector3(100, 0, 0),
      Vector3(0, 0, -99),
      (8, 8),
      (1, 1),
      0
    )(_ => (1, 1, 1, 1))
    val camera = Camera(Vector3.Zero, Vector3(0, 0, -1), Vector3(0, 1, 0), 60, 1, 111)
    Scene("floor", quad, IndexedSeq(material), camera, 0x80a8d8)
  }
}
