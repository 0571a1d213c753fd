package frustum.charts.plot

import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

class LabelPlacementTest extends AnyFunSuite {
  private val seed = 1L
  private val within = Frame(0, 0, 560, 300)

  test("no label lies over another, over a point, or outside") {
    val random = new Random(seed)
    for (n <- 0 until 200) {
      val labels = Seq.fill(14)(Labelled(random.nextDouble() * 560, random.nextDouble() * 300, 6, "12", 16, 12))
      val placed = LabelPlacement(labels, within).flatten
      val points = labels.map(l => Frame(l.x - 6, l.y - 6, l.x + 6, l.y + 6))
      for ((a, i) <- placed.zipWithIndex) {
        assert(within.holds(a), s"seed $seed, case $n")
        assert(!points.exists(a.overlaps) && !placed.drop(i + 1).exists(a.overlaps), s"seed $seed, case $n")
      }
      assert(placed.length >= 13, s"seed $seed, case $n: ${placed.length} of 14 labels have a place")
    }
  }

  test("points that lie together have one label with all their names") {
    def label(x: Double, text: String) = Labelled(x, 50, 5, text, 8, 12)
    val joined = LabelPlacement.joined(Seq(label(10, "1"), label(100, "2"), label(12, "3")), 6, 8.0 * _.length)
    assert(joined.map(_.text) == Seq("1, 3", "2") && joined.head.width == 32)
  }
}
