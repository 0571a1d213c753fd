package frustum.contract.arithmetic

/** A point or direction of a ray-cast scene, in integer units. */
case class IntVector(x: Int, y: Int, z: Int) {
  def apply(axis: Int): Int = Seq(x, y, z)(axis)
  def axes: Seq[Int] = Seq(x, y, z)
  def -(o: IntVector): IntVector = IntVector(x - o.x, y - o.y, z - o.z)
  def dot(o: IntVector): Long = x.toLong * o.x + y.toLong * o.y + z.toLong * o.z
  override def toString = s"($x, $y, $z)"
}
