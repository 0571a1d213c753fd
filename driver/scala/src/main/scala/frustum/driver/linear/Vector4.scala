package frustum.driver.linear

/** Homogeneous coordinates, or a colour with alpha. */
final case class Vector4(x: Double, y: Double, z: Double, w: Double) {
  def +(v: Vector4): Vector4 = Vector4(x + v.x, y + v.y, z + v.z, w + v.w)
  def *(f: Double): Vector4 = Vector4(x * f, y * f, z * f, w * f)

  /** The point a fraction f of the way to v. */
  def lerp(v: Vector4, f: Double): Vector4 =
    Vector4(x + (v.x - x) * f, y + (v.y - y) * f, z + (v.z - z) * f, w + (v.w - w) * f)
}

object Vector4 {
  def point(v: Vector3): Vector4 = Vector4(v.x, v.y, v.z, 1)
  def direction(v: Vector3): Vector4 = Vector4(v.x, v.y, v.z, 0)
}
