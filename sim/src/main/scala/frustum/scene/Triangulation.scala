package frustum.scene

import frustum.driver.linear.Vector3
import scala.collection.mutable

/** Triangles of a polygon, as indices of its corners.
  *
  * @param crossed the polygon crosses itself, so that the triangles do not fill it
  */
final case class Triangulation(triangles: Seq[(Int, Int, Int)], crossed: Boolean)

/** Cuts a polygon into triangles along diagonals within it, by cutting off ears: a corner is one where its triangle
  * turns as the polygon does and holds no other corner (Meisters 1975: every simple polygon has two). A convex
  * polygon becomes the fan of its first corner. Corners may lie on edges, coincide, or touch: a hole joined to the
  * outline by an edge that is passed twice is a hole. Sides are decided exactly. Where a polygon crosses itself, or
  * has no area, there may be no ear: what is left becomes a fan.
  */
object Triangulation {

  /** n - 2 triangles, each in the polygon's direction or without area.
    *
    * @param normal of the polygon's plane, onto which corners are projected
    */
  def apply(corners: IndexedSeq[Vector3], normal: Vector3): Triangulation = {
    val p = flat(corners, normal)
    val fan = (1 until p.length - 1).map(i => (0, i, i + 1))
    if (convex(p, fan)) Triangulation(fan, crossed = false)
    else {
      val ears = new Ears(p).cut()
      Triangulation(ears, crossed = Crossing.exists(p))
    }
  }

  /** Every corner turns left and the fan does not fold: together they leave no room for a second turn. */
  private def convex(p: IndexedSeq[Point2], fan: Seq[(Int, Int, Int)]): Boolean =
    p.indices.forall(i => Orientation(p(i), p((i + 1) % p.length), p((i + 2) % p.length)) > 0) &&
      fan.forall { case (a, b, c) => Orientation(p(a), p(b), p(c)) > 0 }

  /** Corners without the coordinate along which the normal is longest, so that the polygon turns counter-clockwise. */
  private def flat(corners: IndexedSeq[Vector3], normal: Vector3): IndexedSeq[Point2] = {
    val axis = normal.longestAxis
    val (u, v) = ((axis + 1) % 3, (axis + 2) % 3)
    val direction = if (normal(axis) < 0) -1 else 1
    corners.map(c => Point2(c(u), direction * c(v)))
  }

  /** The ring of corners that are still to be cut off. */
  private final class Ears(p: IndexedSeq[Point2]) {
    private val next = Array.tabulate(p.length)(i => (i + 1) % p.length)
    private val prev = Array.tabulate(p.length)(i => (i + p.length - 1) % p.length)
    private val bent = Array.tabulate(p.length)(turn(_) <= 0)
    private var left = p.length
    private var start = 0

    def cut(): Seq[(Int, Int, Int)] = {
      val triangles = mutable.ArrayBuffer.empty[(Int, Int, Int)]
      while (left > 3) {
        // a corner between two edges that lie on each other has nothing in it: it goes first, since it hides others
        val corner = ring.find(folded).orElse(ring.find(isEar)).getOrElse(start)
        triangles += ((prev(corner), corner, next(corner)))
        remove(corner)
      }
      triangles.toSeq :+ ((start, next(start), prev(start)))
    }

    private def ring: Iterator[Int] = Iterator.iterate(start)(next(_)).take(left)

    private def turn(i: Int): Int = Orientation(p(prev(i)), p(i), p(next(i)))

    private def remove(i: Int): Unit = {
      next(prev(i)) = next(i)
      prev(next(i)) = prev(i)
      left -= 1
      start = next(i)
      for (changed <- Seq(prev(i), next(i))) bent(changed) = turn(changed) <= 0
    }

    /** A doubled corner, or the end of a spike without area. */
    private def folded(i: Int): Boolean = bent(i) && turn(i) == 0 && {
      val (a, b, c) = (p(prev(i)), p(i), p(next(i)))
      (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) >= 0
    }

    /** Only corners that do not turn left can lie in the triangle of one that does, if any lies there at all. */
    private def isEar(i: Int): Boolean = !bent(i) && {
      val (a, b, c) = (prev(i), i, next(i))
      !ring.exists(d => d != a && d != b && d != c && (bent(d) || coincides(d, a, b, c)) && blocks(d, a, b, c))
    }

    private def coincides(d: Int, corners: Int*): Boolean = corners.exists(p(_) == p(d))

    private def blocks(d: Int, a: Int, b: Int, c: Int): Boolean = {
      def left(from: Int, to: Int, of: Int) = Orientation(p(from), p(to), p(of)) > 0
      def enters(corner: Int)(in: Int => Boolean) = p(d) == p(corner) && Seq(prev(d), next(d)).exists(in)
      if (coincides(d, a, b, c))
        // it touches a corner of the triangle: it is in the way where the outline goes on into the triangle from there
        enters(a)(n => left(a, b, n) && left(c, a, n)) || enters(b)(n => left(a, b, n) && left(b, c, n)) ||
        enters(c)(n => left(b, c, n) && left(c, a, n))
      else !left(b, a, d) && !left(c, b, d) && !left(a, c, d)
    }
  }
}
