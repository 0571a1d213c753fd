package frustum.charts

import frustum.reference.raster.ExactCoverage
import frustum.synthesis.UnitCosts
import scala.util.Random

/** Sub-pixel bits of vertices: pixels that are covered otherwise than by the unrounded triangle, over random triangles
  * of some 8 pixels.
  */
object SubpixelFamily extends ChartFamily {
  val name = "subpixel"

  private val Unit = 4096 // of "unrounded"
  private val Triangles = 1500

  /** Wrong pixels of 100 covered ones. */
  def wrongPercent(bits: Int, seed: Int): Double = {
    val random = new Random(seed)
    val step = Unit >> bits
    var (wrong, covered) = (0L, 0L)
    for (_ <- 0 until Triangles) {
      def coordinates() = IndexedSeq.fill(3)((random.nextDouble() * 14 * Unit).round)
      val (xs, ys) = (coordinates(), coordinates())
      def snap(v: Long) = (v + step / 2) / step * step
      val clockwise = (xs(1) - xs(0)) * (ys(2) - ys(0)) - (ys(1) - ys(0)) * (xs(2) - xs(0)) > 0
      val order = if (clockwise) Seq(0, 1, 2) else Seq(0, 2, 1)
      def of(v: Long => Long) =
        new ExactCoverage(order.map(i => v(xs(i))).toIndexedSeq, order.map(i => v(ys(i))).toIndexedSeq, Unit)
      val (exact, snapped) = (of(identity), of(snap))
      for (y <- 0 to 14; x <- 0 to 14) {
        if (exact.contains(x, y)) covered += 1
        if (exact.contains(x, y) != snapped.contains(x, y)) wrong += 1
      }
    }
    100.0 * wrong / covered
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val points =
      for (bits <- 0 to 8) yield ChartPoint("snapped vertices", s"$bits bits", bits, wrongPercent(bits, 1))
    Seq(Chart(
      "subpixel",
      "Coverage against sub-pixel bits, triangles of some 8 pixels",
      "sub-pixel bits",
      "wrong pixels, % of covered",
      points,
      points.find(_.cost == 4),
      None,
      1e-3,
      "Each bit halves the error and adds two to every edge function's width."
    ))
  }
}
