package frustum.judge

import frustum.contract.raster.{FramePass, PackedTriangle, RasterConfig, RenderState, TileRegion, Wrap}
import frustum.driver.linear.Vector4
import frustum.driver.raster.{ClipTriangle, DrawOptions, Driver, RepeatRemoval, Viewport}
import frustum.driver.scene.Scene
import frustum.model.raster.{Rasterizer, ScreenFragments}
import frustum.model.raster.texture.Divide
import frustum.reference.raster.{ScreenVertex, TriangleAttributes}
import scala.collection.mutable
import scala.math.{cos, sin, sqrt, Pi}

/** What a moving picture shows beside its motion: by how much the error of a texture coordinate changes from one
  * picture to the next. What is off by the same everywhere and always nobody sees; what changes crawls.
  *
  * @param swimRms,swimMost change of the error, texels: root mean square, and the greatest
  * @param popsPercent      fragments whose error jumps by half a texel or more, of 100
  */
final case class TemporalVerdict(swimRms: Double, swimMost: Double, popsPercent: Double)

/** Pans a scene by 1/16 pixel from picture to picture, 30 degrees upwards from the right, so that no step is a whole
  * sub-pixel. Truth is the scene as it was before vertices were rounded.
  */
object TemporalJudge {
  val Config = RasterConfig(width = 120, height = 160)
  val SubpixelBits = 4
  private val Steps = 16
  private val Pop = 0.5

  /** @param bits sub-pixel bits that vertices are rounded to, 4 at most */
  def pan(scene: Scene, config: RasterConfig, bits: Int): TemporalVerdict = {
    val options = DrawOptions(None, cullBack = false, Wrap.Repeat, 0)
    val frame = Driver.prepare(scene, scene.camera, options, config, 0)
    val errors =
      (0 to Steps).map(k => texelErrors(frame.clipTriangles.map(shifted(_, k / 16.0, config)), config, bits))
    val steps = for {
      (before, after) <- errors.zip(errors.tail)
      (place, (u, v)) <- before
      (u2, v2) <- after.get(place)
    } yield (u2 - u).abs.max((v2 - v).abs)
    if (steps.isEmpty) TemporalVerdict(0, 0, 0)
    else TemporalVerdict(
      sqrt(steps.map(e => e * e).sum / steps.length),
      steps.max,
      100.0 * steps.count(_ >= Pop) / steps.length
    )
  }

  private def shifted(t: ClipTriangle, pixels: Double, config: RasterConfig): ClipTriangle =
    t.copy(v = t.v.map { v =>
      val c = v.clip
      val (dx, dy) = (pixels * cos(Pi / 6), pixels * sin(Pi / 6))
      v.copy(clip =
        Vector4(c.x + 2 * dx / config.width * c.w, c.y + 2 * dy / config.height * c.w, c.z, c.w)
      )
    })

  /** Drawn less true coordinate by triangle and pixel, in texels. */
  private def texelErrors(
      triangles: IndexedSeq[ClipTriangle],
      config: RasterConfig,
      bits: Int
  ): mutable.Map[(Int, Int, Int), (Double, Double)] = {
    val viewport = new Viewport(config)
    val divide = Divide.of(config)
    val step = 1 << 4 - bits
    def snap(v: Int) = (v + step / 2) / step * step
    val offsets = triangles.map(RepeatRemoval.offset)
    val truths = triangles.map(t => new TriangleAttributes(t.v.map(ScreenVertex.of(_, config))))
    val found = mutable.HashMap.empty[(Int, Int, Int), (Double, Double)]
    // Some hundred triangles at a time, as the store holds them.
    for (part <- triangles.indices.grouped(config.maxVertices / 3)) {
      val vertices = part.flatMap(n => triangles(n).v.map(viewport.pack(_, offsets(n))))
        .map(v => v.copy(x = snap(v.x), y = snap(v.y)))
      val pass = FramePass(
        0,
        0,
        TileRegion.whole(config),
        IndexedSeq(RenderState()),
        vertices,
        part.indices.map(n => PackedTriangle(0, 3 * n, 3 * n + 1, 3 * n + 2))
      )
      Rasterizer(config).draw(
        pass,
        new ScreenFragments(config)({ f =>
          val n = part.head + f.triangle
          for (texture <- triangles(n).state.texture) {
            val (truth, offset) = (truths(n)(f.x, f.y), offsets(n))
            def off(plane: Int, exact: Double, whole: Int, size: Int) =
              (divide(plane, f.q) / 131072.0 - (exact - whole)) * size
            found((n, f.x, f.y)) =
              (off(f.s, truth.s, offset._1, texture.width), off(f.t, truth.t, offset._2, texture.height))
          }
        })
      )
    }
    found
  }
}
