package frustum.scene

import frustum.driver.linear.{Vector3, Vector4}
import frustum.driver.raster.Projection
import org.scalatest.funsuite.AnyFunSuite
import scala.math.{Pi, cos, sin, toRadians}

class FramingTest extends AnyFunSuite {
  private val sphere = (Vector3(3, -2, 7), 2.0)

  test("the contract's formula, at a square and at other shapes") {
    val square = Framing(sphere, 1)
    val d = 1.15 * 2 / sin(toRadians(22.5))
    val offset = square.eye - sphere._1
    assert((offset.length - d).abs < 1e-12 && offset.normalized.distance(Vector3(
      0.45,
      0.35,
      0.82
    ).normalized) < 1e-12)
    assert(square.at == sphere._1 && square.up == Vector3(0, 1, 0) && square.fovDegrees == 45)
    assert((square.near - (d - 2.2)).abs < 1e-12 && (square.far - (d + 2.2)).abs < 1e-12)
    assert(Framing(sphere, 2).eye == square.eye, "the smaller field of view is the vertical one")
    assert(Framing(sphere, 0.5).eye.distance(sphere._1) > d * 1.5, "the smaller field of view is the horizontal one")
  }

  test("the whole sphere is in the picture at any aspect, any angle of view and any place") {
    for (aspect <- Seq(0.02, 0.3, 0.75, 1.0, 2.5, 64.0); fov <- Seq(5.0, 45.0, 120.0); radius <- Seq(1e-6, 2.0, 1e6)) {
      val camera = Framing((sphere._1, radius), aspect, fov)
      val toClip = Projection(camera, aspect)
      for (i <- 0 to 8; j <- 0 until 16) {
        val (theta, phi) = (Pi * i / 8, Pi * j / 8)
        val p = Vector3(sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi)) * radius + sphere._1
        val c = toClip * Vector4.point(p)
        assert(Seq(c.x, c.y, c.z).forall(_.abs < c.w), s"aspect $aspect, fov $fov, radius $radius")
      }
    }
  }

  test("given the eye alone the planes follow from its distance") {
    val far = Framing(sphere, 0.75, eye = Some(Vector3(3, -2, 107)))
    assert(far.at == sphere._1 && (far.near - 97.8).abs < 1e-9 && (far.far - 102.2).abs < 1e-9)
    val close = Framing(sphere, 0.75, eye = Some(Vector3(3, -2, 8)))
    assert(close.near == 0.02 && (close.far - 3.2).abs < 1e-9)
  }

  test("looking past the mesh, or away from it, the planes are in order, and what is given counts") {
    val past = Framing(sphere, 1, eye = Some(Vector3(3, -2, 17)), at = Some(Vector3(13, -2, 7)))
    val deep = 10 * sin(Pi / 4)
    assert((past.near - (deep - 2.2)).abs < 1e-9 && (past.far - (deep + 2.2)).abs < 1e-9)
    val away = Framing(sphere, 1, eye = Some(Vector3(3, -2, 17)), at = Some(Vector3(3, -2, 27)))
    assert(away.near > 0 && away.far > away.near)
    val before = Framing(sphere, 1, eye = Some(Vector3(3, -2, 107)), far = Some(50))
    assert(before.near == 0.5 && before.far == 50)
    val asked = Framing(sphere, 1, near = Some(0.5), far = Some(99), up = Some(Vector3(0, 0, 1)), ortho = Some(4))
    assert((asked.near, asked.far, asked.orthoHeight, asked.up.z) == ((0.5, 99.0, Some(4.0), 1.0)))
  }
}
