package frustum.judge

import frustum.contract.raster.{FramePass, RasterConfig}
import frustum.reference.raster.{ExactCoverage, PixelRect}

/** How the covered pixels differ from the exact set, summed over triangles.
  *
  * @param covered pixels of the exact sets
  * @param missing in the exact set, not drawn
  * @param extra   drawn, not in the exact set (each drawing counts)
  * @param twice   further drawings of a pixel that one triangle had drawn already
  */
final case class CoverageVerdict(covered: Long, missing: Long, extra: Long, twice: Long) {
  def wrong: Long = missing + extra + twice
  def +(o: CoverageVerdict): CoverageVerdict =
    CoverageVerdict(covered + o.covered, missing + o.missing, extra + o.extra, twice + o.twice)
}

/** Holds the fragments of a pass against exact coverage, triangle by triangle: because the rule gives each
  * pixel of a shared edge to one triangle, this finds gaps and double hits along edges as well.
  */
object CoverageJudge {
  val Clean: CoverageVerdict = CoverageVerdict(0, 0, 0, 0)

  def judge(pass: FramePass, fragments: Iterable[LoggedFragment], config: RasterConfig): CoverageVerdict = {
    val rect = PixelRect.of(pass.region, config)
    val byTriangle = fragments.groupBy(_.triangle)
    val unknown =
      byTriangle.collect { case (t, f) if t < 0 || t >= pass.triangles.length => f.size.toLong }.sum
    val stamp = Array.fill(config.width * config.height)(-1)
    ExactCoverage.of(pass).zipWithIndex.foldLeft(Clean.copy(extra = unknown)) { case (sum, (exact, index)) =>
      sum + judgeTriangle(exact, rect, byTriangle.getOrElse(index, Nil), config.width, stamp, 2 * index)
    }
  }

  /** `stamp` is scratch: `mark` means in the exact set, `mark + 1` that it was drawn as well. */
  private def judgeTriangle(
      exact: ExactCoverage,
      rect: PixelRect,
      drawn: Iterable[LoggedFragment],
      width: Int,
      stamp: Array[Int],
      mark: Int
  ): CoverageVerdict = {
    var covered, seen, extra, twice = 0L
    exact.foreach(rect) { (x, y) => stamp(y * width + x) = mark; covered += 1 }
    drawn.foreach { f =>
      val inside = rect.contains(f.x, f.y)
      val state = if (inside) stamp(f.y * width + f.x) else -1
      if (state == mark) { seen += 1; stamp(f.y * width + f.x) = mark + 1 }
      else if (state == mark + 1) twice += 1
      else extra += 1
    }
    CoverageVerdict(covered, covered - seen, extra, twice)
  }
}
