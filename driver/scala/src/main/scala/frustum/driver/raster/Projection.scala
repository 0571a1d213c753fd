package frustum.driver.raster

import frustum.contract.InputError
import frustum.driver.linear.{Matrix4, Vector3}
import frustum.driver.scene.Camera

/** World to clip space, OpenGL's conventions: eye looks along -z, inside is -w <= x, y, z <= w. */
object Projection {

  /** Beyond, squares of lengths would leave double precision. */
  private val Farthest = 1e30

  /** @param aspect width / height of the screen; InputError where the camera sees nothing */
  def apply(camera: Camera, aspect: Double): Matrix4 = {
    check(camera)
    val projection = camera.orthoHeight match {
      case Some(h) => Matrix4.orthographic(h * aspect, h, camera.near, camera.far)
      case None    =>
        Matrix4.perspective(scala.math.toRadians(camera.fovDegrees), aspect, camera.near, camera.far)
    }
    projection * Matrix4.lookAt(camera.eye, camera.at, camera.up)
  }

  private def check(c: Camera): Unit = {
    def refuse(condition: Boolean, message: => String): Unit = if (condition) throw InputError(message)
    def show(v: Vector3) = s"${v.x},${v.y},${v.z}"
    for ((name, v) <- Seq("eye" -> c.eye, "at" -> c.at, "up" -> c.up)) {
      refuse(!v.isFinite, s"camera: $name ${show(v)} is not finite; give three numbers")
      refuse(
        v.axes.exists(_.abs > Farthest),
        s"camera: $name ${show(v)} is beyond +-$Farthest; come closer"
      )
    }
    val forward = c.at - c.eye
    refuse(forward.length == 0, s"camera: eye and at are the same point ${show(c.eye)}; move one of them")
    refuse(
      forward.normalized.cross(c.up.normalized).length < 1e-6 || c.up.length == 0,
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
