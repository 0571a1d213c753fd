package frustum.referee

import scala.math.{cos, hypot, sin, toRadians}

/** Rays of a picture of a voxel world by the contract of the command line: z is up; the ray of pixel (i, j), j
  * downwards, is look + right (i + 0.5 - width / 2) / focal + up (height / 2 - j - 0.5) / focal.
  *
  * @param eye   in blocks
  * @param look  unit length
  * @param right level, unit length
  * @param focal pixels from the eye to the screen
  */
final case class VoxelRays(eye: Vec, look: Vec, right: Vec, focal: Double, width: Int, height: Int) {
  val up: Vec = right cross look

  def direction(i: Int, j: Int): Vec =
    look + right * ((i + 0.5 - width / 2.0) / focal) + up * ((height / 2.0 - j - 0.5) / focal)

  /** How far a direction, of any length, lies from that of a pixel, in pixels on the screen. */
  def error(i: Int, j: Int, d: Vec): Double = {
    val ahead = d dot look
    hypot(
      focal * (d dot right) / ahead - (i + 0.5 - width / 2.0),
      focal * (d dot up) / ahead - (height / 2.0 - j - 0.5)
    )
  }
}

object VoxelRays {

  /** Degrees: yaw 0 looks along +x, 90 along +y; a pitch of 90 looks straight up. */
  def ofAngles(eye: Vec, yaw: Double, pitch: Double, focal: Double, width: Int, height: Int): VoxelRays = {
    def level(degrees: Double) = Vec(cos(toRadians(degrees)), sin(toRadians(degrees)), 0)
    val look = level(yaw) * cos(toRadians(pitch)) + Vec(0, 0, 1) * sin(toRadians(pitch))
    VoxelRays(eye, look, level(yaw - 90), focal, width, height)
  }

  /** Looking along a direction of any length; straight up and down as with a yaw of 0. */
  def ofDirection(eye: Vec, along: Vec, focal: Double, width: Int, height: Int): VoxelRays = {
    val level = along cross Vec(0, 0, 1)
    val right = if (level.length > 0) level.unit else Vec(0, -1, 0)
    VoxelRays(eye, along.unit, right, focal, width, height)
  }
}
