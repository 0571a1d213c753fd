package frustum.referee

import frustum.driver.linear.Vector3
import scala.math.{cos, sin, tan, toRadians}

/** A vertex in homogeneous window coordinates: (x, y) / w in pixels from the bottom left corner, z / w the depth from
  * -1 (near) to 1 (far), w the distance along the line of sight (1 in an orthographic view).
  */
final case class WindowVertex(x: Double, y: Double, z: Double, w: Double)

/** From the world to the window without matrices, each step from the definition of what OpenGL offers for it:
  * gluLookAt and gluPerspective (OpenGL Utility Library 1.3, 4.1 and 4.2), glOrtho, glRotate (OpenGL 2.1, 2.11.2) and
  * the viewport (2.11.1) with its origin at the bottom left.
  */
final case class EyeSpace(view: WorldView) {
  import view.camera
  private val position = Vec(camera.eye)
  private val forward = (Vec(camera.at) - position).unit
  private val right = (forward cross Vec(camera.up)).unit
  private val up = right cross forward
  private val angle = toRadians(view.turnDegrees)

  /** glRotate(turn, 0, 1, 0) of a direction. */
  def turned(d: Vec): Vec =
    Vec(d.x * cos(angle) + d.z * sin(angle), d.y, d.z * cos(angle) - d.x * sin(angle))

  /** To the right, upwards, and ahead of the eye: z is positive for what is seen. */
  def eye(p: Vector3): Vec = {
    val d = turned(Vec(p) - view.middle) + (view.middle - position)
    Vec(d dot right, d dot up, d dot forward)
  }

  /** Half the width and half the height of what is seen at distance 1, or anywhere in an orthographic view. */
  private val halfHeight = camera.orthoHeight.fold(tan(toRadians(camera.fovDegrees) / 2))(_ / 2)
  private val halfWidth = halfHeight * view.width / view.height

  def window(p: Vector3): WindowVertex = {
    val e = eye(p)
    val (near, far) = (camera.near, camera.far)
    val (z, w) = camera.orthoHeight match {
      case Some(_) => ((2 * e.z - near - far) / (far - near), 1.0)
      case None    => ((e.z * (far + near) - 2 * far * near) / (far - near), e.z)
    }
    WindowVertex(
      (e.x / halfWidth + w) * view.width / 2,
      (e.y / halfHeight + w) * view.height / 2,
      z,
      w
    )
  }
}
