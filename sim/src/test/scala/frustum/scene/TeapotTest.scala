package frustum.scene

import frustum.driver.linear.Vector3
import org.scalatest.funsuite.AnyFunSuite

class TeapotTest extends AnyFunSuite {
  private def white(n: Vector3) = (1.0, 1.0, 1.0, 1.0)

  test("32 patches with the published extent") {
    assert(Teapot.parts.length == 32)
    val points = Teapot.parts.flatMap(_.patch.control.flatten)
    assert(
      (points.map(_.x).min, points.map(_.x).max, points.map(_.z).min, points.map(_.z).max) == ((
        -3.0,
        3.525,
        0.0,
        3.15
      ))
    )
    assert((points.map(_.y).min, points.map(_.y).max) == ((-2.0, 2.0)))
  }

  test("control points of the published table") {
    val points = Teapot.parts.flatMap(_.patch.control.flatten)
    for (
      (x, y, z) <- Seq(
        (1.4, -0.784, 2.4),
        (0.98, 1.75, 1.875),
        (-0.45, -0.8, 3.15),
        (0.112, -0.2, 2.7),
        (-2.65, -0.3, 0.9375),
        (3.45, 0.15, 2.5125),
        (-0.798, 1.425, 0.0)
      )
    )
      assert(points.exists(_.distance(Vector3(x, y, z)) < 1e-12), (x, y, z))
  }

  test("neighbouring patches share their edge, point and normal") {
    def edge(p: BezierPatch, u: Option[Double], v: Option[Double]) =
      (0 to 4).map(i => (u.getOrElse(i / 4.0), v.getOrElse(i / 4.0))).map { case (a, b) =>
        (p.point(a, b), p.normal(a, b))
      }
    // the first eight parts are the rim's and the upper body's quarters
    for (start <- Seq(0, 4, 8, 12, 16, 20); quarter <- 0 to 3) {
      val here = edge(Teapot.parts(start + quarter).patch, None, Some(1))
      val next = edge(Teapot.parts(start + (quarter + 1) % 4).patch, None, Some(0))
      for (((p, n), (q, m)) <- here.zip(next)) assert(p.distance(q) < 1e-12 && n.distance(m) < 1e-9)
    }
    for ((upper, lower) <- Seq((0, 4), (4, 8), (8, 20)); quarter <- 0 to 3) {
      val above = edge(Teapot.parts(upper + quarter).patch, Some(1), None)
      val below = edge(Teapot.parts(lower + quarter).patch, Some(0), None)
      for (((p, n), (q, m)) <- above.zip(below)) assert(p.distance(q) < 1e-12 && n.distance(m) < 1e-9)
    }
  }

  test("normals at the poles point along the axis") {
    val poles = Teapot.parts
      .flatMap(part =>
        Seq((0.0, 0.3), (1.0, 0.7), (0.0, 0.0), (1.0, 1.0)).map { case (u, v) =>
          part.patch.point(u, v) -> part.patch.normal(u, v)
        }
      )
      .filter { case (p, _) => p.x.abs < 1e-12 && p.y.abs < 1e-12 }
    assert(poles.length == 4 * 2 * 2)
    for ((p, n) <- poles) assert(n.distance(Vector3(0, 0, if (p.z > 1) 1 else -1)) < 1e-9)
  }

  test("normals are the slopes' limit everywhere") {
    for (part <- Teapot.parts; u <- Seq(0.05, 0.4, 0.93); v <- Seq(0.1, 0.6)) {
      val (p, e) = (part.patch.point(u, v), 1e-5)
      val du = part.patch.point(u + e, v) - p
      val dv = part.patch.point(u, v + e) - p
      assert(du.cross(dv).normalized.dot(part.patch.normal(u, v)) > 0.999, s"${part.name} $u $v")
    }
  }

  test("tessellation is a parameter") {
    val counts = Seq(1, 3, 6, 12).map(Teapot.triangles(_, white).length)
    assert(counts == counts.sorted && counts.distinct == counts)
    assert(counts(2) <= 1000 && counts(3) > 3 * counts(2))
  }
}
