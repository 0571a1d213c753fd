package frustum.driver.raster

import frustum.contract.InputError
import frustum.driver.scene.Camera
import org.joml.{Matrix4d, Vector3d}

/** World to clip space, OpenGL's conventions: eye looks along -z, inside is -w <= x, y, z <= w. */
object Projection {

  /** Beyond, squares of lengths would leave double precision. */
  private val Farthest = 1e30

  /** @param aspect width / height of the screen; InputError where the camera sees nothing */
  def apply(camera: Camera, aspect: Double): Matrix4d = {
    check(camera)
    val projection = new Matrix4d
    camera.orthoHeight match {
      case Some(h) =>
        projection.ortho(-h / 2 * aspect, h / 2 * aspect, -h / 2, h / 2, camera.near, camera.far)
      case None =>
        projection.perspective(scala.math.toRadians(camera.fovDegrees), aspect, camera.near, camera.far)
    }
    projection.lookAt(camera.eye, camera.at, camera.up)
  }

  private def check(c: Camera): Unit = {
    def refuse(condition: Boolean, message: => String): Unit = if (condition) throw InputError(message)
    def show(v: Vector3d) = s"${v.x},${v.y},${v.z}"
    for ((name, v) <- Seq("eye" -> c.eye, "at" -> c.at, "up" -> c.up)) {
      refuse(!v.isFinite, s"camera: $name ${show(v)} is not finite; give three numbers")
      refuse(
        v.absolute(new Vector3d).get(v.maxComponent) > Farthest,
        s"camera: $name ${show(v)} is beyond +-$Farthest; come closer"
      )
    }
    val forward = new Vector3d(c.at).sub(c.eye)
    refuse(forward.length == 0, s"camera: eye and at are the same point ${show(c.eye)}; move one of them")
    refuse(
      new Vector3d(forward).normalize.cross(new Vector3d(c.up).normalize).length < 1e-6 || c.up.length == 0,
      s"camera: up ${show(c.up)} lies along the line of sight; choose another up"
    )
    refuse(
      !(c.near.isFinite && c.far.isFinite && c.near < c.far),
      s"camera: near ${c.near} must be less than far ${c.far}"
    )
    c.orthoHeight match {
      case Some(h) => refuse(!(h > 0 && h.isFinite), s"camera: ortho $h must be above 0")
      case None    =>
        refuse(c.near <= 0, s"camera: near ${c.near} must be above 0 in a perspective view")
        refuse(
          !(c.fovDegrees > 0 && c.fovDegrees < 180),
          s"camera: fov ${c.fovDegrees} must lie between 0 and 180 degrees"
        )
    }
  }
}
