package frustum.scene

import frustum.driver.linear.Vector3
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** Triangles of polygons: positive or without area, together the polygon's area, and covering each point as often as
  * the even-odd rule says.
  */
class TriangulationTest extends AnyFunSuite {
  private type Point = (Double, Double)

  private def area(p: Seq[Point]): Double =
    p.zip(p.tail :+ p.head).map { case ((ax, ay), (bx, by)) => ax * by - bx * ay }.sum / 2

  private def inside(p: Seq[Point], x: Double, y: Double): Boolean =
    p.zip(p.tail :+ p.head).count { case ((ax, ay), (bx, by)) =>
      (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
    } % 2 == 1

  private def cut(p: Seq[Point]): Seq[Seq[Point]] = {
    val cuts = Triangulation(p.map { case (x, y) => Vector3(x, y, 0) }.toIndexedSeq, Vector3(0, 0, 1))
    assert(!cuts.crossed && cuts.triangles.length == p.length - 2)
    cuts.triangles.map { case (a, b, c) => Seq(p(a), p(b), p(c)) }
  }

  private def check(p: Seq[Point], clue: String, random: Random): Unit = {
    val triangles = cut(p)
    assert(triangles.forall(area(_) >= 0), s"$clue: $p: a triangle turns the other way")
    assert((triangles.map(area).sum - area(p)).abs < 1e-9 * area(p), s"$clue: $p")
    val (xs, ys) = (p.map(_._1), p.map(_._2))
    for (_ <- 0 until 60) {
      val (x, y) = (xs.min + random.nextDouble() * (xs.max - xs.min), ys.min + random.nextDouble() * (ys.max - ys.min))
      assert(triangles.count(inside(_, x, y)) == (if (inside(p, x, y)) 1 else 0), s"$clue: $p at $x, $y")
    }
  }

  private def fromEachCorner(p: Seq[Point], clue: String): Unit = {
    val random = new Random(1)
    for (first <- p.indices) check(p.drop(first) ++ p.take(first), clue, random)
  }

  test("a doubled corner inwards") {
    fromEachCorner(Seq((-1, -1), (1, -1), (1, -1), (1, 1), (0, -0.5), (0, -0.5), (-1, 1)), "doubled")
  }

  test("a comb, one of its corners not quite where it should be") {
    val teeth = (0 until 10).flatMap(i =>
      Seq((0.9 - 0.2 * i, -0.6), (0.9 - 0.2 * i, 1.0), (0.8 - 0.2 * i, 1.0), (0.8 - 0.2 * i, -0.6))
    )
    fromEachCorner(Seq((-1.0, -1.0), (1.0, -1.0), (1.0, -0.6)) ++ teeth.dropRight(1) :+ ((-1.0, 1.0)), "comb")
  }

  test("corners on edges, spikes without area") {
    fromEachCorner(Seq((0, 0), (1, 0), (2, 0), (3, 0), (3, 3), (2, 3), (0, 3), (0, 1)), "corners on edges")
    fromEachCorner(Seq((0, 0), (2, 0), (4, 0), (2, 0), (2, 2), (0, 2)), "spike")
    fromEachCorner(Seq((0, 0), (4, 0), (4, 4), (2, 1), (0, 4)), "notch")
  }

  test("holes joined to the outline by an edge that is passed twice, touching corners") {
    val hole = Seq((0, 0), (6, 0), (6, 6), (0, 6), (0, 0), (2, 2), (2, 4), (4, 4), (4, 2), (2, 2)).map(p =>
      (p._1.toDouble, p._2.toDouble)
    )
    fromEachCorner(hole, "hole")
    val holes = Seq(
      (0, 0),
      (9, 0),
      (9, 6),
      (0, 6),
      (0, 0),
      (1, 1),
      (1, 4),
      (3, 4),
      (3, 1),
      (1, 1),
      (0, 0),
      (5, 1),
      (5, 4),
      (8, 4),
      (5, 1)
    )
    fromEachCorner(holes.map(p => (p._1.toDouble, p._2.toDouble)), "two holes from one corner")
    fromEachCorner(Seq((0, 0), (4, 0), (4, 4), (2, 1), (0, 4)).map(p => (p._1.toDouble, p._2.toDouble)), "notch")
    fromEachCorner(
      Seq((0, 0), (3, 0), (2, 2), (4, 4), (0, 4), (2, 2)).map(p => (p._1.toDouble, p._2.toDouble)),
      "hourglass"
    )
  }

  test("random simple polygons, with doubled corners and corners on edges") {
    val seed = 16
    val random = new Random(seed)
    for (n <- 4 to 60; _ <- 0 until 6) {
      // sorted by angle about the middle: simple, with many corners inwards; on a grid, so that corners line up
      val star = Seq.fill(n)(random.nextDouble() * 2 * math.Pi).sorted.map { a =>
        val r = 1 + random.nextInt(40)
        ((r * math.cos(a)).round.toDouble, (r * math.sin(a)).round.toDouble)
      }.filter(_ != ((0.0, 0.0)))
      val angles = star.map { case (x, y) => math.atan2(y, x) }
      val simple = angles.distinct.length == angles.length && area(star) > 0
      if (simple && star.length >= 4) {
        val twice = star.flatMap(p => if (random.nextInt(4) == 0) Seq(p, p) else Seq(p))
        val split = twice.zip(twice.tail :+ twice.head).flatMap { case (a, b) =>
          if (random.nextInt(4) == 0) Seq(a, ((a._1 + b._1) / 2, (a._2 + b._2) / 2)) else Seq(a)
        }
        val ordered = area(split) > 0 && !Crossing.exists(split.map { case (x, y) =>
          Point2(x, y)
        }.toIndexedSeq)
        if (ordered) check(split, s"seed $seed, $n corners", random)
      }
    }
  }

  test("a polygon that crosses itself is told, one that is convex or touches itself is not") {
    def crossed(p: Point*) =
      Triangulation(p.map { case (x, y) => Vector3(x, y, 0) }.toIndexedSeq, Vector3(0, 0, 1)).crossed
    val star = (0 until 5).map(i => (math.cos(i * 0.8 * math.Pi), math.sin(i * 0.8 * math.Pi)))
    assert(crossed((0, 0), (1, 1), (1, 0), (0, 1)) && crossed(star: _*))
    assert(!crossed((0, 0), (1, 0), (1, 1), (0, 1)) && !crossed((0, 0), (3, 0), (2, 2), (4, 4), (0, 4), (2, 2)))
  }

  test("a thousand corners take no time to speak of") {
    val p = (0 until 1000).map(i => {
      val r = 10.0 + i % 7; (r * math.cos(i * math.Pi / 500), r * math.sin(i * math.Pi / 500))
    })
    val clock = java.lang.management.ManagementFactory.getThreadMXBean
    val start = clock.getCurrentThreadCpuTime
    cut(p)
    val seconds = (clock.getCurrentThreadCpuTime - start) / 1e9
    info(f"$seconds%.2f s")
    assert(seconds < 5)
    check(p, "gear", new Random(1))
  }

  test("sides are decided exactly where rounding would not") {
    val (a, b) = (Point2(0.5, 0.5), Point2(12, 12))
    assert(Orientation(a, b, Point2(24, 24)) == 0)
    assert(Orientation(a, b, Point2(24, Math.nextUp(24.0))) == 1 && Orientation(
      a,
      b,
      Point2(24, Math.nextDown(24.0))
    ) == -1)
    assert(Orientation(Point2(1e-200, 0), Point2(0, 1e-200), Point2(-1e-200, 0)) == 1)
  }
}
