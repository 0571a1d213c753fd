package frustum.referee

import frustum.driver.linear.Vector3

/** A vector of three; the referee has an algebra of its own, so that no fault is shared with what it judges. */
final case class Vec(x: Double, y: Double, z: Double) {
  def +(o: Vec): Vec = Vec(x + o.x, y + o.y, z + o.z)
  def -(o: Vec): Vec = Vec(x - o.x, y - o.y, z - o.z)
  def *(k: Double): Vec = Vec(x * k, y * k, z * k)
  def dot(o: Vec): Double = x * o.x + y * o.y + z * o.z
  def cross(o: Vec): Vec = Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x)
  def length: Double = scala.math.sqrt(this dot this)
  def unit: Vec = this * (1 / length)
}

object Vec {
  def apply(v: Vector3): Vec = Vec(v.x, v.y, v.z)
}
