package frustum.scene

import frustum.driver.linear.Vector3
import frustum.driver.scene.Camera
import scala.math.{atan, sin, tan, toRadians}

/** The camera of a mesh that has none: all of its bounding sphere is in the picture, whatever the picture's shape. */
object Framing {

  /** From the sphere's centre to the eye. */
  private def direction = Vector3(0.45, 0.35, 0.82).normalized

  /** With c and r the sphere's centre and radius: eye = c + d * direction, d = 1.15 r / sin(half of the smaller of
    * the two fields of view); looking at c. Near and far are 1.1 r before and behind c along the line of sight,
    * near not below 0.01 r, far not before near. What is given takes the place of what follows from the sphere, and
    * the rest follows from that.
    *
    * @param sphere centre and radius
    * @param aspect width / height of the picture
    * @param fov    vertical, degrees
    */
  def apply(
      sphere: (Vector3, Double),
      aspect: Double,
      fov: Double = 45,
      eye: Option[Vector3] = None,
      at: Option[Vector3] = None,
      up: Option[Vector3] = None,
      near: Option[Double] = None,
      far: Option[Double] = None,
      ortho: Option[Double] = None
  ): Camera = {
    val centre = sphere._1
    val radius = if (sphere._2 > 0) sphere._2 else 1.0
    val from = eye.getOrElse(direction * (1.15 * radius / sin(halfAngle(fov, aspect))) + centre)
    val to = at.getOrElse(centre)
    val sight = (to - from).normalized
    val middle = (centre - from).dot(sight)
    // a far plane that is given may lie before the mesh: then nothing is seen, but the planes are in order
    val before = near.getOrElse {
      val ofSphere = (middle - 1.1 * radius).max(0.01 * radius)
      far.filter(f => f > 0 && f <= ofSphere).fold(ofSphere)(_ / 100)
    }
    val behind = far.getOrElse(if (middle + 1.1 * radius > before) middle + 1.1 * radius else before + radius)
    Camera(from, to, up.getOrElse(Vector3(0, 1, 0)), fov, before, behind, ortho)
  }

  /** Half of the smaller field of view, radians. */
  private def halfAngle(fov: Double, aspect: Double): Double = {
    val vertical = toRadians(fov.min(179) / 2)
    vertical.min(atan(tan(vertical) * aspect))
  }
}
