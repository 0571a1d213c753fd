package frustum.driver.raster

import frustum.driver.raster.Fixtures._
import org.scalatest.funsuite.AnyFunSuite

class ViewportTest extends AnyFunSuite {
  private val viewport = new Viewport(config)

  private def at(x: Double, y: Double, z: Double = 0, w: Double = 1) =
    viewport.pack(clipVertex(x * w, y * w, z * w, w), (0, 0))

  test("corners: x right, y down, near 0, far 65535") {
    assert((at(-1, 1, -1).x, at(-1, 1, -1).y, at(-1, 1, -1).z) == ((0, 0, 0)))
    assert((at(1, -1, 1).x, at(1, -1, 1).y, at(1, -1, 1).z) == ((240 * 16, 320 * 16, 65535)))
    assert(at(0, 0, 0, w = 100).x == 120 * 16)
  }

  test("snapping goes to the nearest sixteenth") {
    def column(pixels: Double) = at(pixels / 120 - 1, 0).x
    assert(column(10 + 0.49 / 16) == 160)
    assert(column(10 + 0.51 / 16) == 161)
    assert(column(-10 - 0.51 / 16) == -161)
    assert(column(100.5) == 100 * 16 + 8)
  }

  test("1/w, texture coordinates and colour") {
    val p = viewport.pack(clipVertex(0, 0, 0, 3, s = 5.25, t = -1.5), (4, 0))
    assert(((p.qMantissa * scala.math.pow(2, p.qExponent - 31)) * 3 - 1).abs < 1.0 / 65536)
    assert((p.s, p.t) == ((81920, -98304)))
    assert((p.r, p.a) == ((255, 255)))
    assert(Seq(-0.2, 0.0, 0.5, 1.0, 7.0).map(Viewport.byte) == Seq(0, 0, 128, 255, 255))
  }

  test("area is exact and positive when clockwise on the screen") {
    val (a, b, c) = (at(0, 0), at(1, 0), at(0, -1)) // right, then down
    assert(viewport.area(a, b, c) == 120L * 16 * 160 * 16)
    assert(viewport.area(a, c, b) == -120L * 16 * 160 * 16)
  }

  test("pixel boxes hold the centres only") {
    def packed(x: Int, y: Int) = at(0, 0).copy(x = x, y = y)
    assert(viewport.pixels(Seq(packed(8, 8), packed(24, 8), packed(8, 25))) == Some(PixelBox(0, 0, 1, 1)))
    assert(viewport.pixels(Seq(packed(9, 9), packed(23, 9), packed(9, 23))) == None)
    assert(viewport.pixels(Seq(packed(-500, -500), packed(-20, -30), packed(-100, -9))) == None)
    assert(
      viewport.pixels(Seq(packed(-500, -500), packed(9000, -500), packed(0, 9000))) == Some(
        PixelBox(0, 0, 239, 319)
      )
    )
  }
}
