package frustum.driver.linear

/** A point or a direction in space. */
final case class Vector3(x: Double, y: Double, z: Double) {
  def +(v: Vector3): Vector3 = Vector3(x + v.x, y + v.y, z + v.z)
  def -(v: Vector3): Vector3 = Vector3(x - v.x, y - v.y, z - v.z)
  def unary_- : Vector3 = Vector3(-x, -y, -z)
  def *(f: Double): Vector3 = Vector3(x * f, y * f, z * f)
  def /(f: Double): Vector3 = Vector3(x / f, y / f, z / f)
  def dot(v: Vector3): Double = x * v.x + (y * v.y + z * v.z)

  /** Right-handed: x cross y is z. */
  def cross(v: Vector3): Vector3 = Vector3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x)
  def length: Double = scala.math.sqrt(dot(this))
  def distance(v: Vector3): Double = (this - v).length

  /** Of length 1; not a number for a vector of length 0. */
  def normalized: Vector3 = this * (1 / length)

  /** Turned about an axis of length 1 by an angle in radians, counter-clockwise for one who looks against the axis:
    * Rodrigues' formula.
    */
  def turned(axis: Vector3, angle: Double): Vector3 = {
    val (sin, cos) = (scala.math.sin(angle), scala.math.cos(angle))
    this * cos + axis.cross(this) * sin + axis * (axis.dot(this) * (1 - cos))
  }
  def min(v: Vector3): Vector3 = Vector3(x.min(v.x), y.min(v.y), z.min(v.z))
  def max(v: Vector3): Vector3 = Vector3(x.max(v.x), y.max(v.y), z.max(v.z))

  /** Along axis 0, 1 or 2. */
  def apply(axis: Int): Double = axes(axis)

  /** The axis along which it is longest, the first of equals. */
  def longestAxis: Int = (0 to 2).maxBy(apply(_).abs)
  def axes: Seq[Double] = Seq(x, y, z)
  def isFinite: Boolean = axes.forall(a => !a.isNaN && !a.isInfinite)
}

object Vector3 {
  val Zero: Vector3 = Vector3(0, 0, 0)
  val Axes: IndexedSeq[Vector3] = IndexedSeq(Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1))
}
