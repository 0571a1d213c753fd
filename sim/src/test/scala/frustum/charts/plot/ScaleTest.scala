package frustum.charts.plot

import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

class ScaleTest extends AnyFunSuite {
  private val seed = 1L

  test("every axis has three numbers at least and eleven at most, within its ends and in order") {
    val random = new Random(seed)
    for (n <- 0 until 2000; log <- Seq(false, true)) {
      val low = math.pow(10, random.between(-9.0, 6.0))
      val high = low * (1 + math.pow(10, random.between(-1.5, 8.0)))
      val scale = Scale.over(Seq(low, high), log)
      val ticks = scale.ticks.map(_._1)
      assert(ticks.length >= 3 && ticks.length <= 11, s"seed $seed, case $n: $low to $high, log $log: $ticks")
      assert(ticks == ticks.sorted && ticks.forall(t => scale(t) > -1e-3 && scale(t) < 1.001), s"case $n: $ticks")
      assert(scale.ticks.map(_._2).distinct.length == ticks.length, s"case $n: ${scale.ticks}")
    }
  }

  test("a logarithmic axis of less than a decade has more than one number") {
    assert(Scale(0.030, 0.034, log = true).ticks.map(_._2) == Seq("0.03", "0.031", "0.032", "0.033", "0.034"))
    assert(Scale(25, 170, log = true).ticks.map(_._2) == Seq("40", "60", "80", "100", "120", "140", "160"))
  }

  test("over three decades: 1, 2 and 5; over many: powers of ten") {
    assert(Scale(1, 100, log = true).ticks.map(_._2) == Seq("1", "2", "5", "10", "20", "50", "100"))
    assert(Scale(1e-6, 1, log = true).ticks.map(_._2) == Seq("10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1"))
  }

  test("what is 0, or below the floor, has a row of its own on a logarithmic axis") {
    val scale = Scale.over(Seq(0, 1e-7, 0.1, 10), log = true, floor = 1e-3)
    assert(scale.zero && scale.ticks.head == 0.0 -> "none")
    assert(scale(0) < scale(0.1) && scale(0) > 0)
  }

  test("one value, or none, is an axis too") {
    for (values <- Seq(Seq(5.0), Nil); log <- Seq(false, true)) assert(Scale.over(values, log).ticks.length >= 3)
    assert(Scale.over(Seq(0.0), log = true).ticks.head._2 == "none")
  }

  test("numbers are written as a reader writes them") {
    val written = Seq(0.0, 0.05, 12.0, 1200.0, 1495525.0, 3e-6, 1e-6, 2e9).map(Scale.text)
    assert(written == Seq("0", "0.05", "12", "1,200", "1,495,525", "3 × 10⁻⁶", "10⁻⁶", "2 × 10⁹"))
  }
}
