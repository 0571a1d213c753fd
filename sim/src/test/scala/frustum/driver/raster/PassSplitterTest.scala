package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{FramePass, PackedVertex, RasterConfig, RenderState, TileRegion}
import frustum.driver.linear.Vector3
import frustum.driver.raster.Fixtures._
import frustum.driver.scene.Triangle
import frustum.engine.raster.{PassEngine, ReferenceRenderer}
import frustum.model.raster.RasterModel
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

  /** A grid of small squares, two triangles each, over `size` pixels. */
  private def dense(steps: Int, size: Double, z: Double = 0): Seq[Triangle] = {
    def at(i: Int, j: Int) = vertex(size * (i.toDouble / steps - 0.5), size * (j.toDouble / steps - 0.5), z)
    for (
      i <- 0 until steps; j <- 0 until steps;
      t <- Seq(
        triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1)),
        triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1))
      )
    ) yield t
  }

  test("of a mesh denser than the pixels only the triangles that cover one are sent, and the picture is the same") {
    // 2 x 120 x 120 triangles over 48 x 48 pixels: 6.25 squares a pixel
    val mesh = prepare(scene(dense(120, 48)))
    val image = new PassEngine(new ReferenceRenderer(_)).drawAll(Seq(mesh)).head.image
    val plain = new PassEngine(new ReferenceRenderer(_)).drawAll(Seq(prepare(scene(dense(1, 48))))).head.image
    assert(mesh.passes.flatMap(p => tiles(p.region)).sorted == tiles(TileRegion.whole(config)).sorted)
    assert(mesh.passes.forall(p =>
      p.vertices.length <= config.maxVertices && p.triangles.length <= config.maxTriangles
    ))
    assert(image.toSeq == plain.toSeq && image.count(_ != 0) == 48 * 48)
  }

  test("what is hidden is not sent where there is no room for it, and the bit-exact picture is the same") {
    val ball = scene(sphere(50, 80, 100))
    val lit = options.copy(light = Some(Vector3(1, 2, 3)))
    val store = RasterConfig(maxVertices = 120)
    val (large, small) = (prepare(ball, lit), prepare(ball, lit, store))
    val all = large.passes.flatMap(l => l.triangles.map(t => Seq(t.v0, t.v1, t.v2).map(l.vertices))).distinct
    val thinned = small.passes.map { p =>
      val box = PixelBox(p.region.x0 * 16, p.region.y0 * 16, p.region.x1 * 16 + 15, p.region.y1 * 16 + 15)
      p.triangles.length -> all.count(PixelCover.covers(_, box))
    }.filter { case (sent, covering) => sent < covering }
    val (sent, covering) = (thinned.map(_._1).sum, thinned.map(_._2).sum)
    info(s"in ${thinned.length} passes $sent triangles are sent of $covering that cover a pixel")
    assert(thinned.nonEmpty && small.passes.forall(_.vertices.length <= 120))
    def image(frame: PreparedFrame) = new PassEngine(new RasterModel(_)).drawAll(Seq(frame)).head.image.toSeq
    assert(image(small) == image(large))
  }

  test("glass hides nothing, and is hidden itself; what is cut out hides nothing") {
    val front = triangle(vertex(-50, -50, 5), vertex(50, -50, 5), vertex(0, 50, 5))
    val back = triangle(vertex(-20, -20, -5), vertex(20, -20, -5), vertex(0, 20, -5))
    val opaque = RenderState()
    val glass = RenderState(blend = true, depthWrite = false)
    val holes = RenderState(alphaRef = 16)
    val p = prepare(scene(Seq(front, back))).passes.head
    val viewport = new Viewport(config)
    def packed(states: (Int, Int)) = p.triangles.zip(Seq(states._1, states._2)).map { case (t, state) =>
      val v = Seq(t.v0, t.v1, t.v2).map(p.vertices)
      PackedCorners(state, v(0), v(1), v(2), viewport.pixels(v).get)
    }
    def seen(states: (Int, Int)) =
      HiddenTriangles.without(packed(states), PixelBox(0, 0, 239, 319), IndexedSeq(opaque, glass, holes)).map(_.state)
    assert(seen((0, 0)) == Seq(0) && seen((0, 1)) == Seq(0) && seen((0, 2)) == Seq(0))
    assert(seen((1, 0)) == Seq(1, 0) && seen((2, 0)) == Seq(2, 0))
  }

  test("what would help is said: culling, and whether it is enough") {
    val front = Seq.fill(9)(triangle(vertex(0, 0), vertex(9, 0), vertex(0, 9)))
    val back = front.map(t => Triangle(t.v0, t.v2, t.v1, 0))
    def refusal(n: Int) =
      intercept[InputError](prepare(scene(front.take(n) ++ back), config = RasterConfig(maxTriangles = 8))).message
    assert(refusal(8).contains("17 triangles with 3 vertices") && refusal(
      8
    ).contains("--cull back leaves 8 of them with 3 vertices; "))
    assert(refusal(9).contains("--cull back leaves 9 of them with 3 vertices, too many as well; "))
    assert(refusal(9).contains("a larger picture (--size)"))
  }

  test("covered pixels: exact, ties on the safe side") {
    val random = new scala.util.Random(5)
    val box = PixelBox(3, 2, 9, 12)
    def at(x: Int, y: Int) = PackedVertex(x, y, 0, 32768, 0, 0, 0, 0, 0, 0, 0)
    for (_ <- 0 until 3000) {
      val p = Seq.fill(3)(at(random.nextInt(260), random.nextInt(260)))
      val area = new Viewport(config).area(p(0), p(1), p(2))
      val corners = if (area < 0) p.reverse else p
      val covered = for (y <- box.y0 to box.y1; x <- box.x0 to box.x1) yield {
        val c = at(16 * x + 8, 16 * y + 8)
        (0 to 2).forall(i => new Viewport(config).area(corners(i), corners((i + 1) % 3), c) >= 0)
      }
      if (area != 0) assert(PixelCover.covers(corners, box) == covered.contains(true), corners)
    }
  }

  test("an empty frame is one pass that clears the screen") {
    val p = prepare(scene(Nil), options.copy(background = 0xff0000))
    assert(p.passes.map(_.region) == Seq(TileRegion.whole(config)))
    assert(p.passes.head.clearColor == 0xf800 && p.passes.head.triangles.isEmpty)
  }
}
