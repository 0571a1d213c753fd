package frustum.judge

import frustum.contract.raster.{FramePass, RenderState, Wrap}
import frustum.reference.raster.{Attributes, ExactCoverage, Sampler, ScreenVertex, Shading, TriangleAttributes}

/** Texels against the reference's.
  *
  * @param judged          textured fragments whose true coordinates keep clear of a texel border
  * @param wrong           of these, another texel was read
  * @param wrongByMoreThanOne of these, one at least two texels away in either direction
  * @param maxError        greatest distance in texels, the larger of the two directions
  */
final case class AttributeVerdict(judged: Long, wrong: Long, wrongByMoreThanOne: Long, maxError: Int) {
  def +(o: AttributeVerdict): AttributeVerdict = AttributeVerdict(
    judged + o.judged,
    wrong + o.wrong,
    wrongByMoreThanOne + o.wrongByMoreThanOne,
    maxError.max(o.maxError)
  )
}

object AttributeJudge {
  val Clean: AttributeVerdict = AttributeVerdict(0, 0, 0, 0)

  /** A true coordinate closer than this to a texel border, in texels, is not judged. */
  val Border: Double = 1.0 / 1024

  def judge(pass: FramePass, fragments: Iterable[LoggedFragment]): AttributeVerdict = {
    val coverage = ExactCoverage.of(pass)
    val planes = pass.triangles.map { t =>
      new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(pass.vertices(i))))
    }
    fragments.foldLeft(Clean) { (sum, f) =>
      // A fragment outside its triangle is the coverage judge's affair: it has no true coordinate.
      if (!coverage.isDefinedAt(f.triangle) || !coverage(f.triangle).contains(f.x, f.y)) sum
      else
        one(pass.states(pass.triangles(f.triangle).state), planes(f.triangle)(f.x, f.y), f.texelS, f.texelT)
          .fold(sum)(sum + _)
    }
  }

  /** The verdict on one fragment, None where it is not judged. */
  def one(state: RenderState, truth: Attributes, texelS: Int, texelT: Int): Option[AttributeVerdict] =
    Shading.textureOf(state).flatMap { texture =>
      val (u, v) = (truth.s * texture.width, truth.t * texture.height)
      if (nearBorder(u) || nearBorder(v)) None
      else {
        val error = distance(
          u,
          texelS,
          texture.width,
          state.wrapS
        ).max(distance(v, texelT, texture.height, state.wrapT))
        Some(AttributeVerdict(1, if (error > 0) 1 else 0, if (error > 1) 1 else 0, error))
      }
    }

  private def nearBorder(u: Double) = (u - u.round).abs < Border

  /** Texels between the one read and the true one; with repeat the first and the last texel are
    * neighbours.
    */
  def distance(u: Double, texel: Int, size: Int, wrap: Wrap): Int = {
    val straight = (Sampler.wrap(u.floor.toLong, size, wrap) - texel).abs
    if (wrap == Wrap.Repeat) straight.min((size - straight).abs) else straight
  }
}
