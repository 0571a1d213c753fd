package frustum.driver.linear

import org.scalatest.funsuite.AnyFunSuite
import scala.math.{Pi, sqrt}

/** Vectors and matrices against numbers worked out by hand. */
class LinearTest extends AnyFunSuite {
  private val Seq(x, y, z) = Vector3.Axes
  private val (a, b) = (Vector3(1, 2, 3), Vector3(-4, 5, 6))

  private def close(v: Vector3, w: Vector3): Boolean = v.distance(w) < 1e-12

  /** The point in normalised device coordinates. */
  private def divided(v: Vector4) = Vector3(v.x, v.y, v.z) / v.w

  test("sums, products and lengths") {
    assert(a + b == Vector3(-3, 7, 9) && a - b == Vector3(5, -3, -3) && -a == Vector3(-1, -2, -3))
    assert(a * 2 == Vector3(2, 4, 6) && b / 2 == Vector3(-2, 2.5, 3))
    assert(a.dot(b) == 24 && a.cross(b) == Vector3(-3, -18, 13) && x.cross(y) == z)
    assert(Vector3(2, 3, 6).length == 7 && a.distance(b) == sqrt(43))
    assert(close(Vector3(0, 3, 4).normalized, Vector3(0, 0.6, 0.8)) && !Vector3.Zero.normalized.isFinite)
    assert(a.min(b) == Vector3(-4, 2, 3) && a.max(b) == Vector3(1, 5, 6))
  }

  test("axes of a vector") {
    assert((0 to 2).map(a(_)) == Seq(1, 2, 3) && a.axes == Seq(1, 2, 3))
    assert(Vector3(1, -3, 2).longestAxis == 1 && Vector3(1, -1, 1).longestAxis == 0 && Vector3(
      0,
      1,
      -1
    ).longestAxis == 1)
    assert(a.isFinite && !Vector3(0, Double.NaN, 0).isFinite && !Vector3(0, 0, Double.NegativeInfinity).isFinite)
  }

  test("a quarter turn takes each axis to the next, about the diagonal a third does") {
    for ((axis, from, to) <- Seq((x, y, z), (y, z, x), (z, x, y))) assert(close(from.turned(axis, Pi / 2), to))
    assert(close(a.turned(Vector3(1, 1, 1).normalized, 2 * Pi / 3), Vector3(3, 1, 2)))
    assert(close(Matrix4.rotationY(Pi / 2).direction(z), x) && close(
      Matrix4.rotationY(0.7).direction(a),
      a.turned(y, 0.7)
    ))
  }

  test("the point on the way between two") {
    assert(Vector4(0, 2, 4, 8).lerp(Vector4(4, 2, 0, 0), 0.25) == Vector4(1, 2, 3, 6))
    assert(Vector4(1, 2, 3, 4) + Vector4(1, 1, 1, 1) * 2 == Vector4(3, 4, 5, 6))
  }

  test("a product of matrices does the right one first; directions are not moved") {
    val both = Matrix4.translation(Vector3(10, 0, 0)) * Matrix4.rotationY(Pi / 2)
    assert(close(both.point(z), Vector3(11, 0, 0)) && close(both.direction(z), x))
    assert(Matrix4.translation(a) * Vector4(1, 1, 1, 2) == Vector4(3, 5, 7, 2))
  }

  test("perspective: a view of 90 degrees ends at 45 on each side, the planes at -1 and 1") {
    val m = Matrix4.perspective(Pi / 2, 2, 1, 9)
    assert(close(divided(m * Vector4(2, 1, -1, 1)), Vector3(1, 1, -1)))
    assert(close(divided(m * Vector4(-18, -9, -9, 1)), Vector3(-1, -1, 1)))
    assert((m * Vector4(5, 6, -7, 1)).w == 7)
  }

  test("orthographic: the corners of the view volume are those of the cube") {
    val m = Matrix4.orthographic(8, 6, 1, 9)
    assert(close(m.point(Vector3(4, 3, -1)), Vector3(1, 1, -1)) && close(
      m.point(Vector3(-4, -3, -9)),
      Vector3(-1, -1, 1)
    ))
  }

  test("look-at: the eye is the origin, what it looks at lies along -z, up along +y") {
    val m = Matrix4.lookAt(Vector3(5, 1, 0), Vector3(2, 1, 0), Vector3(1, 3, 0))
    assert(close(m.point(Vector3(5, 1, 0)), Vector3.Zero) && close(m.point(Vector3(2, 1, 0)), Vector3(0, 0, -3)))
    assert(close(m.direction(y), y) && close(m.direction(z), -x))
  }
}
