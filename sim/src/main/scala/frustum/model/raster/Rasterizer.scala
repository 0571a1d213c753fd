package frustum.model.raster

import frustum.contract.raster.{FramePass, RasterConfig, RenderState}
import frustum.contract.raster.SetupWords._
import frustum.model.raster.scan.EdgeWalker
import frustum.model.raster.setup.TriangleSetup

/** Takes what the rasterizer makes of a frame, in the hardware's order. */
trait FragmentSink {
  def tile(tileX: Int, tileY: Int): Unit

  /** A covered pixel of the tile; planes as in `frustum.raster.scan.InterpolatedFragment`. */
  def fragment(
      triangle: Int,
      state: RenderState,
      x: Int,
      y: Int,
      s: Int,
      t: Int,
      q: Int,
      z: Int,
      r: Int,
      g: Int,
      b: Int,
      a: Int
  ): Unit
  def tileEnd(tileX: Int, tileY: Int): Unit
}

/** Bit-exact rasterizer: tiles of the region row by row, in each the triangles in order, in each the spans to and fro.
  */
final case class Rasterizer(config: RasterConfig) {
  import config.formats.cut
  import config.ranges.wrap

  def draw(pass: FramePass, sink: FragmentSink): Unit = {
    val setups = pass.triangles.map { t =>
      val setup = new TriangleSetup(config.fixed.planes)
      if (setup.setup(pass.vertices(t.v0), pass.vertices(t.v1), pass.vertices(t.v2))) Some(setup) else None
    }
    for (tileY <- pass.region.y0 to pass.region.y1; tileX <- pass.region.x0 to pass.region.x1) {
      sink.tile(tileX, tileY)
      for (n <- setups.indices; setup <- setups(n)) drawInTile(pass, n, setup, tileX, tileY, sink)
      sink.tileEnd(tileX, tileY)
    }
  }

  private def drawInTile(
      pass: FramePass,
      n: Int,
      setup: TriangleSetup,
      tileX: Int,
      tileY: Int,
      sink: FragmentSink
  ): Unit = {
    val (originX, originY) = (tileX * config.tileWidth, tileY * config.tileHeight)
    val right = scala.math.min(originX + config.tileWidth, config.width) - 1
    val bottom = scala.math.min(originY + config.tileHeight, config.height) - 1
    if (mayTouch(pass, n, originX, right, originY, bottom)) {
      setup.edges(originX, right, originY, bottom)
      val spans =
        if (setup.outside) Seq()
        else EdgeWalker.spans(originX, right, originY, bottom, setup.edge, setup.stepX, setup.stepY)
      spans.headOption.foreach { first =>
        setup.rebase(first.first, first.y)
        val state = pass.states(pass.triangles(n).state)
        for ((span, row) <- spans.zipWithIndex) {
          val pixels = if (row % 2 == 0) span.first to span.last else span.last to span.first by -1
          for (x <- pixels) {
            def plane(p: Int) =
              cut(p, setup.initial(p)) + (x - first.first) * cut(p, setup.gradientX(p)) + (span.y - first.y) * cut(
                p,
                setup.gradientY(p)
              )
            sink.fragment(
              n,
              state,
              x - originX,
              span.y - originY,
              wrap(plane(PlaneS)),
              wrap(plane(PlaneT)),
              plane(PlaneQ),
              plane(PlaneZ),
              plane(PlaneR).toShort.toInt,
              plane(PlaneG).toShort.toInt,
              plane(PlaneB).toShort.toInt,
              plane(PlaneA).toShort.toInt
            )
          }
        }
      }
    }
  }

  /** Whether the bounding box reaches into the tile; a mere saving of time. */
  private def mayTouch(pass: FramePass, n: Int, left: Int, right: Int, top: Int, bottom: Int): Boolean = {
    val t = pass.triangles(n)
    val v = Seq(t.v0, t.v1, t.v2).map(pass.vertices)
    v.exists(_.x >= 16 * left) && v.exists(_.x < 16 * right + 16) && v.exists(_.y >= 16 * top) && v.exists(
      _.y < 16 * bottom + 16
    )
  }
}
