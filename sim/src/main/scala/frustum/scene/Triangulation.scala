package frustum.scene

import org.joml.{Vector2d, Vector3d}
import scala.collection.mutable

/** Cuts a polygon into triangles along diagonals within it, by cutting off ears: a corner is one where its triangle turns
  * as the polygon does and holds no other corner (Meisters 1975: every simple polygon has two). A convex polygon becomes
  * the fan of its first corner. Where a polygon crosses itself, or has no area, there may be no ear: what is left becomes
  * a fan.
  */
object Triangulation {

  /** n - 2 triangles as indices of corners, each in the polygon's direction.
    *
    * @param normal of the polygon's plane, onto which corners are projected
    */
  def apply(corners: IndexedSeq[Vector3d], normal: Vector3d): Seq[(Int, Int, Int)] = {
    val p = flat(corners, normal)
    def area(a: Int, b: Int, c: Int) =
      (p(b).x - p(a).x) * (p(c).y - p(a).y) - (p(b).y - p(a).y) * (p(c).x - p(a).x)
    val ring = corners.indices.toBuffer
    val triangles = mutable.ArrayBuffer.empty[(Int, Int, Int)]

    /** The triangle at place i of the ring. */
    def at(i: Int) = (ring((i + ring.length - 1) % ring.length), ring(i), ring((i + 1) % ring.length))
    def turn(i: Int) = { val (a, b, c) = at(i); area(a, b, c) }
    def isEar(i: Int) = {
      val (a, b, c) = at(i)
      def inside(d: Int) = area(a, b, d) >= 0 && area(b, c, d) >= 0 && area(c, a, d) >= 0
      turn(i) > 0 && !ring.exists(d => d != a && d != b && d != c && !Seq(a, b, c).exists(p(_) == p(d)) && inside(d))
    }
    while (ring.length > 3 && ring.indices.exists(turn(_) < 0) && ring.indices.exists(isEar)) {
      val ear = ring.indices.find(isEar).get
      triangles += at(ear)
      ring.remove(ear)
    }
    triangles.toSeq ++ (1 until ring.length - 1).map(i => (ring(0), ring(i), ring(i + 1)))
  }

  /** Corners without the coordinate along which the normal is longest, so that the polygon turns counter-clockwise. */
  private def flat(corners: IndexedSeq[Vector3d], normal: Vector3d): IndexedSeq[Vector2d] = {
    val axis = normal.maxComponent
    val (u, v) = ((axis + 1) % 3, (axis + 2) % 3)
    val direction = if (normal.get(axis) < 0) -1 else 1
    corners.map(c => new Vector2d(c.get(u), direction * c.get(v)))
  }
}
