package frustum.judge

import frustum.contract.raster.{FramePass, RasterConfig, RenderState}
import frustum.reference.raster.{ExactCoverage, PixelRect, ReferenceFrame, ScreenVertex, Shading, TriangleAttributes}

/** What is seen, against the reference.
  *
  * @param primitiveWrong  pixels whose colour was last written by another triangle than in the reference
  * @param depthOrderWrong pixels whose depth is owned by a triangle that, by the reference's depths, lies
  *                        behind the one that should own it
  */
final case class DepthVerdict(primitiveWrong: Long, depthOrderWrong: Long) {
  def +(o: DepthVerdict): DepthVerdict =
    DepthVerdict(primitiveWrong + o.primitiveWrong, depthOrderWrong + o.depthOrderWrong)
}

/** Replays the alpha and depth tests on the model's fragments to find which triangle owns each pixel. The
  * alpha that is tested is that of the texel the model read, combined with the vertex alpha of the reference.
  */
final class DepthJudge(pass: FramePass, config: RasterConfig, memory: Array[Int]) {
  private val pixels = config.width * config.height
  private val depth = Array.fill(pixels)(65535)
  private val winner = Array.fill(pixels)(-1)
  private val nearest = Array.fill(pixels)(-1)
  private val rect = PixelRect.of(pass.region, config)
  private val coverage = ExactCoverage.of(pass)
  private val planes = pass.triangles.map { t =>
    new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(pass.vertices(i))))
  }

  /** @param reference the pass drawn by the reference, its triangles numbered from 0 */
  def judge(fragments: Iterable[LoggedFragment], reference: ReferenceFrame): DepthVerdict = {
    fragments.foreach(replay)
    val primitives = (0 until pixels).count(i => winner(i) != reference.winner(i))
    val order = (0 until pixels).count { i =>
      val (mine, its) = (nearest(i), reference.nearest(i))
      mine != its && mine >= 0 && its >= 0 && trueDepth(mine, i) > trueDepth(its, i)
    }
    DepthVerdict(primitives, order)
  }

  private def trueDepth(triangle: Int, pixel: Int) =
    planes(triangle)(pixel % config.width, pixel / config.width).z

  private def replay(f: LoggedFragment): Unit =
    if (coverage.isDefinedAt(f.triangle) && coverage(f.triangle).doubleArea > 0 && rect.contains(f.x, f.y)) {
      val state = pass.states(pass.triangles(f.triangle).state)
      val i = f.y * config.width + f.x
      val passed = state.depth.passes(f.depth, depth(i)) && Shading.passesAlphaTest(state, alpha(state, f))
      if (passed) {
        winner(i) = f.triangle
        if (state.depthWrite) { depth(i) = f.depth; nearest(i) = f.triangle }
      }
    }

  private def alpha(state: RenderState, f: LoggedFragment): Double =
    if (state.alphaRef == 0) 255
    else Shading.color(state, memory, planes(f.triangle)(f.x, f.y), Some((f.texelS, f.texelT))).a
}
