package frustum.driver.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.InputError
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.driver.linear.Vector3
import scala.math.{cos, sin, toRadians}

/** A pose in a voxel world: eye in blocks, angles in degrees; yaw 0 looks along +x, 90 along +y, pitch 90 up.
  *
  * @param focal pixels from the eye to the screen
  * @param asked the direction to look along, where the user gave one in place of angles
  */
final case class VoxelView(eye: Vector3, yaw: Double, pitch: Double, focal: Double, asked: Option[Vector3] = None) {
  private val (cy, sy) = (cos(toRadians(yaw)), sin(toRadians(yaw)))
  private val (cp, sp) = (cos(toRadians(pitch)), sin(toRadians(pitch)))
  val look = Vector3(cy * cp, sy * cp, sp)
  val right = Vector3(sy, -cy, 0)
  val up = Vector3(-cy * sp, -sy * sp, cp)

  /** Direction of pixel (i, j), j downwards. */
  def direction(i: Int, j: Int, c: VoxelConfig): Vector3 =
    look + right * ((i + 0.5 - c.width / 2.0) / focal) + up * ((c.height / 2.0 - j - 0.5) / focal)

  /** Rounded to what the hardware takes; a view that it does not take is refused. */
  def camera(c: VoxelConfig): VoxelCamera = {
    val axes = Seq(("x", eye.x, c.size.x), ("y", eye.y, c.size.y), ("z", eye.z, c.size.z))
    for ((axis, e, size) <- axes) if (!(e >= -VoxelConfig.Around && e <= size + VoxelConfig.Around))
      throw InputError(
        s"--eye: $axis $e is more than ${VoxelConfig.Around} blocks away from the world of ${c.size}; move it nearer"
      )
    if (!(pitch.abs <= 90)) throw InputError(s"--pitch $pitch: is beyond straight up or down; give -90 to 90")
    val corners = for (i <- Seq(0, c.width); j <- Seq(0, c.height)) yield direction(i, j, c)
    if (corners.exists(d => d.x.abs.max(d.y.abs).max(d.z.abs) >= 1.999)) throw InputError(
      s"--focal $focal at ${c.width}x${c.height}: the view is too wide, a ray's component reaches 2; enlarge --focal"
    )
    val longest = 1 << c.slopeBits - 2
    if (focal > longest) throw InputError(
      s"--focal $focal: rays with slopes of ${c.slopeBits} bits pass their pixels by up to a quarter of one at " +
        s"$longest; reduce --focal"
    )
    def fixed(v: Vector3, bits: Int) = {
      def round(x: Double) = (x * (1 << bits)).round.toInt
      IntVector(round(v.x), round(v.y), round(v.z))
    }
    def direct(v: Vector3) = fixed(v, VoxelCamera.DirectionBits)
    VoxelCamera(
      fixed(eye, c.eyeBits),
      direct(look),
      direct(direction(0, 0, c)),
      direct(right / focal),
      direct(up / -focal)
    )
  }
}

object VoxelView {

  /** Yaw and pitch of a direction; straight up and down has yaw 0. */
  def angles(look: Vector3): (Double, Double) = {
    val flat = scala.math.hypot(look.x, look.y)
    (
      if (flat == 0) 0 else scala.math.atan2(look.y, look.x).toDegrees,
      scala.math.atan2(look.z, flat).toDegrees
    )
  }
}
