package frustum.fit

import frustum.contract.InputError
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Camera, Scene}
import frustum.files.{InputFile, JsonFile}
import frustum.scene.Framing
import java.nio.file.Path
import scala.math.{acos, pow, toDegrees, toRadians}
import scala.util.{Random, Try}

/** Where a scene is seen from, relative to its own camera: the eye is turned about the point it looks at.
  *
  * @param turn      degrees about the camera's up
  * @param elevation degrees added to the eye's height above the plane at right angles to up; ends 1 degree before
  *   straight up and down
  * @param distance  factor of the distance
  */
final case class View(turn: Double, elevation: Double, distance: Double) {
  def camera(own: Camera): Camera = {
    val up = own.up.normalized
    val offset = own.eye - own.at
    val height = 90 - toDegrees(acos((offset.dot(up) / offset.length).max(-1).min(1)))
    val raised = (height + elevation).max(-89).min(89) - height
    val right = up.cross(offset).normalized
    val turned = offset.turned(right, -toRadians(raised)).turned(up, toRadians(turn))
    own.copy(eye = own.at + turned * distance)
  }
  override def toString = f"turn $turn%.2f, elevation $elevation%.2f, distance $distance%.3f"
}

/** The views that a configuration has to be good for; both ends included. */
final case class CameraVolume(
    turn: (Double, Double),
    elevation: (Double, Double),
    distance: (Double, Double)
) {
  def random(r: Random): View = View(
    within(turn, r.nextDouble()),
    within(elevation, r.nextDouble()),
    distance._1 * pow(distance._2 / distance._1, r.nextDouble())
  )

  /** A view near by, `reach` of the volume's extent away at most. */
  def near(v: View, reach: Double, r: Random): View = {
    def step(range: (Double, Double), at: Double) =
      (at + (range._2 - range._1) * reach * (2 * r.nextDouble() - 1)).max(range._1).min(range._2)
    View(step(turn, v.turn), step(elevation, v.elevation), step(distance, v.distance))
  }

  /** The camera of a mesh without one, its near and far planes as far apart as the volume's distances need. */
  def framed(scene: Scene): Camera = {
    val camera = scene.camera
    def at(factor: Double) = Framing(scene.boundingSphere, 1, eye = Some(View(0, 0, factor).camera(camera).eye))
    camera.copy(near = at(distance._1).near, far = at(distance._2).far)
  }

  private def within(range: (Double, Double), f: Double) = range._1 + f * (range._2 - range._1)
}

object CameraVolume {
  val default: CameraVolume = CameraVolume((-30, 30), (-10, 10), (0.9, 1.5))

  /** JSON: `{"turn": [low, high], "elevation": [low, high], "distance": [low, high]}`; what is absent is as by default.
    */
  def read(file: Path): CameraVolume = {
    val document = JsonFile.read(file, "./sbt \"fit --help\"")
    val json = document.root.objOpt.getOrElse(document.refuse(
      "",
      s"is no JSON object; write {${keys.map(k => s""""$k": [low, high]""").mkString(", ")}}"
    ))
    json.keys.find(!keys.contains(_)).foreach(k =>
      document.refuse(k, s"there is no '$k'; keys are ${keys.mkString(", ")}")
    )
    def range(key: String, otherwise: (Double, Double), least: Double): (Double, Double) =
      json.get(key).fold(otherwise) { v =>
        Try((v(0).num, v(1).num)).toOption.filter { case (a, b) =>
          v.arr.length == 2 && least < a && a <= b && b < 1e6
        }.getOrElse(
          document.refuse(key, s"$key is $v; give [low, high], above $least and in this order")
        )
      }
    CameraVolume(
      range("turn", default.turn, -1e6),
      range("elevation", default.elevation, -1e6),
      range("distance", default.distance, 0)
    )
  }
  private val keys = Seq("turn", "elevation", "distance")
}
