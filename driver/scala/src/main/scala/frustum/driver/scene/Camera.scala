package frustum.driver.scene

import frustum.driver.linear.Vector3

/** Where a scene is seen from; world units, right-handed, as OpenGL's lookAt and perspective (or ortho) take
  * it.
  *
  * @param fovDegrees
  *   vertical field of view
  * @param near,far
  *   distances of the clipping planes; both exact
  * @param orthoHeight
  *   full height of the view volume: when given the projection is orthographic
  */
final case class Camera(
    eye: Vector3,
    at: Vector3,
    up: Vector3,
    fovDegrees: Double,
    near: Double,
    far: Double,
    orthoHeight: Option[Double] = None
)
