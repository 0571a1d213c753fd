package frustum.charts.plot

import org.jfree.chart.axis.{AxisState, ValueTick}
import org.jfree.chart.ui.RectangleEdge
import org.scalatest.funsuite.AnyFunSuite
import java.awt.geom.Rectangle2D
import scala.jdk.CollectionConverters._
import scala.util.Random

class PlotAxisTest extends AnyFunSuite {
  private val seed = 1L
  private val area = new Rectangle2D.Double(0, 0, 540, 280)
  private val edges = Seq(RectangleEdge.BOTTOM, RectangleEdge.LEFT)

  /** What is written beside an axis. */
  private def ticks(scale: Scale, edge: RectangleEdge): Seq[(Double, String)] = {
    val axis = PlotAxis("", scale)
    axis.setTickLabelFont(PictureFiles.font(12.5))
    axis.refreshTicks(PictureFiles.ruler, new AxisState, area, edge).asScala.toSeq
      .collect { case t: ValueTick if t.getText.nonEmpty => t.getValue -> t.getText }
  }
  private def written(scale: Scale) = ticks(scale, RectangleEdge.LEFT).sortBy(_._1).map(_._2)

  test("every axis has three numbers at least, each another text, within its ends") {
    val random = new Random(seed)
    for (n <- 0 until 1000; log <- Seq(false, true); edge <- edges) {
      val low = math.pow(10, random.between(-9.0, 6.0))
      val high = low * (1 + math.pow(10, random.between(-1.5, 8.0)))
      val scale = Scale.over(Seq(low, high), log)
      val all = ticks(scale, edge)
      assert(all.length >= 3, s"seed $seed, case $n: $low to $high, log $log, $edge: $all")
      assert(all.map(_._2).distinct.length == all.length, s"seed $seed, case $n, $edge: $all")
      assert(all.forall(t => t._1 >= scale.start && t._1 <= scale.high), s"seed $seed, case $n, $edge: $all")
    }
  }

  test("one value, or none, is an axis too") {
    for (values <- Seq(Seq(5.0), Nil); log <- Seq(false, true); edge <- edges)
      assert(ticks(Scale.over(values, log), edge).length >= 3)
  }

  test("a logarithmic axis has 1, 2 and 5 where there is room, powers of ten where they are many") {
    assert(written(Scale(1, 100, log = true)).containsSlice(Seq("1", "2")))
    assert(written(Scale(
      1e-6,
      1,
      log = true
    )).containsSlice(Seq("10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1")) ||
      written(Scale(1e-6, 1, log = true)).contains("0.5"))
    assert(written(Scale(0.030, 0.034, log = true)).contains("0.032"))
  }

  test("what is 0, or below the floor, has a row of its own on a logarithmic axis") {
    val scale = Scale.over(Seq(0, 1e-7, 0.1, 10), log = true, floor = 1e-3)
    assert(scale.zero && written(scale).head == "none" && written(Scale.over(Seq(0.0), log = true)).head == "none")
    assert(scale.drawn(1e-7) == scale.drawn(0) && scale.drawn(0) > scale.start && scale.drawn(0) < 0.1)
  }
}
