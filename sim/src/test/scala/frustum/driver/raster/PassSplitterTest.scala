package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{FramePass, RasterConfig, TileRegion}
import frustum.driver.raster.Fixtures._
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class PassSplitterTest extends AnyFunSuite {
  private def tiles(r: TileRegion) = for (y <- r.y0 to r.y1; x <- r.x0 to r.x1) yield (x, y)

  /** The drawn triangles as sets of vertices, with the pixels of their boxes. */
  private def corners(p: FramePass) =
    p.triangles.map(t => (t.state, p.vertices(t.v0), p.vertices(t.v1), p.vertices(t.v2)))

  for ((maxVertices, maxTriangles) <- Seq((1024, 1024), (1024, 200), (120, 1024), (110, 150)))
    test(
      s"teapot in a store of $maxVertices vertices and $maxTriangles triangles: nothing lost, nothing twice"
    ) {
      val small = RasterConfig(maxVertices = maxVertices, maxTriangles = maxTriangles, tileLog2Width = 5)
      val whole = prepare(Scenes.teapot())
      val split = prepare(Scenes.teapot(), config = small, frame = 3)
      assert(whole.passes.length == 1)
      assert(split.passes.length == 1 || maxVertices < 1024 || maxTriangles < 1024)
      assert(split.passes.flatMap(p => tiles(p.region)).sorted == tiles(TileRegion.whole(small)).sorted)
      assert(split.passes.map(_.frame).distinct.length == split.passes.length)
      val viewport = new Viewport(small)
      val all = corners(whole.passes.head)
      for (p <- split.passes) {
        assert(p.vertices.length <= maxVertices && p.triangles.length <= maxTriangles)
        val inRegion = all.filter { case (_, a, b, c) =>
          val box = viewport.pixels(Seq(a, b, c)).get
          tiles(p.region).exists { case (x, y) =>
            box.x0 < (x + 1) * 32 && box.x1 >= x * 32 && box.y0 < (y + 1) * 16 && box.y1 >= y * 16
          }
        }
        assert(corners(p) == inRegion)
      }
      assert(split.trianglesDrawn == whole.trianglesDrawn)
    }

  test("too many triangles in one tile are refused with the numbers") {
    val stack = Seq.fill(9)(triangle(vertex(0, 0), vertex(9, 0), vertex(0, 9)))
    val error = intercept[InputError](prepare(scene(stack), config = RasterConfig(maxTriangles = 8)))
    assert(
      error.message.contains("9 triangles with 3 vertices") && error.message.contains("holds 8 triangles")
    )
  }

  test("an empty frame is one pass that clears the screen") {
    val p = prepare(scene(Nil), options.copy(background = 0xff0000))
    assert(p.passes.map(_.region) == Seq(TileRegion.whole(config)))
    assert(p.passes.head.clearColor == 0xf800 && p.passes.head.triangles.isEmpty)
  }
}
