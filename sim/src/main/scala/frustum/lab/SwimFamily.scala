package frustum.lab

import frustum.host.{ClipTriangle, DrawOptions, Driver, RepeatRemoval, Viewport}
import frustum.model.raster.{Rasterizer, ScreenFragments}
import frustum.model.texture.PerspectiveDivide
import frustum.reference.raster.{ScreenVertex, TriangleAttributes}
import frustum.scene.Scenes
import frustum.spec._
import org.joml.Vector4d
import scala.collection.mutable
import scala.math.{cos, sin, sqrt, Pi}

/** Swimming: by how much the error of a texture coordinate changes while a scene moves by 1/16 pixel. What is off by the same
  * everywhere and always nobody sees; what changes crawls.
  *
  * Truth is the scene as it was before vertices were rounded.
  */
object SwimFamily extends ChartFamily {
  val name = "swim"

  private val config   = RasterConfig(width = 120, height = 160)
  private val viewport = new Viewport(config)
  private val Steps    = 16

  /** Change of error from step to step, in texels. */
  final case class Swim(rms: Double, most: Double)

  /** @param bits sub-pixel bits that vertices are rounded to, 4 at most */
  def swim(scene: String, bits: Int): Swim = {
    val s      = Scenes.byName(scene)
    val frame  = Driver.prepare(s, s.camera, DrawOptions(None, cullBack = true, Wrap.Repeat, 0), config, 0)
    val errors = (0 to Steps).map(k => texelErrors(frame.clipTriangles.map(shifted(_, k / 16.0)), bits))
    val steps  = for {
      (before, after) <- errors.zip(errors.tail)
      (place, (u, v)) <- before
      (u2, v2)        <- after.get(place)
    } yield (u2 - u).abs.max((v2 - v).abs)
    Swim(sqrt(steps.map(e => e * e).sum / steps.length), steps.max)
  }

  /** Moved by so many pixels, 30 degrees upwards from the right, so that no step is a whole sub-pixel. */
  private def shifted(t: ClipTriangle, pixels: Double): ClipTriangle = t.copy(v = t.v.map { v =>
    val c        = v.clip
    val (dx, dy) = (pixels * cos(Pi / 6), pixels * sin(Pi / 6))
    v.copy(clip = new Vector4d(c.x + 2 * dx / config.width * c.w, c.y + 2 * dy / config.height * c.w, c.z, c.w))
  })

  /** Drawn less true coordinate by triangle and pixel, in texels. */
  private def texelErrors(
      triangles: IndexedSeq[ClipTriangle],
      bits: Int
  ): mutable.Map[(Int, Int, Int), (Double, Double)] = {
    val step         = 1 << 4 - bits
    def snap(v: Int) = (v + step / 2) / step * step
    val offsets      = triangles.map(RepeatRemoval.offset)
    val vertices     = triangles.zip(offsets).flatMap { case (t, offset) =>
      t.v.map(viewport.pack(_, offset)).map(v => v.copy(x = snap(v.x), y = snap(v.y)))
    }
    val pass = FramePass(
      0,
      0,
      TileRegion.whole(config),
      IndexedSeq(RenderState()),
      vertices,
      triangles.indices.map(n => PackedTriangle(0, 3 * n, 3 * n + 1, 3 * n + 2))
    )
    val truths = triangles.map(t => new TriangleAttributes(t.v.map(ScreenVertex.of(_, config))))
    val found  = mutable.HashMap.empty[(Int, Int, Int), (Double, Double)]
    Rasterizer(config).draw(
      pass,
      new ScreenFragments(config)(f =>
        for (texture <- triangles(f.triangle).state.texture) {
          val (truth, offset) = (truths(f.triangle)(f.x, f.y), offsets(f.triangle))
          def off(plane: Int, exact: Double, whole: Int, size: Int) =
            (PerspectiveDivide(plane, f.q) / 131072.0 - (exact - whole)) * size
          found((f.triangle, f.x, f.y)) =
            (off(f.s, truth.s, offset._1, texture.width), off(f.t, truth.t, offset._2, texture.height))
        }
      )
    )
    found
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val points = for (scene <- Seq("cube", "terrain"); bits <- 0 to 4)
      yield ChartPoint(scene, s"$bits bits", bits, swim(scene, bits).rms)
    Seq(Chart(
      "swim",
      "Swimming of texels against sub-pixel bits, scenes moved by 1/16 pixel",
      "sub-pixel bits",
      "change of the texel error from step to step, root mean square, texels",
      points,
      points.find(p => p.method == "cube" && p.cost == 4),
      points.find(p => p.method == "cube" && p.cost == 2),
      1e-4,
      "Each bit takes a third to a half of it. The peers' vertices have 2 bits."
    ))
  }
}
