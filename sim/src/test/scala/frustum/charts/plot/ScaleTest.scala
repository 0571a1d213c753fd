package frustum.charts.plot

import org.scalatest.funsuite.AnyFunSuite

class ScaleTest extends AnyFunSuite {
  test("numbers are written as a reader writes them") {
    val written = Seq(0.0, 0.05, 12.0, 1200.0, 1495525.0, 3e-6, 1e-6, 2e9).map(Scale.text)
    assert(written == Seq("0", "0.05", "12", "1,200", "1,495,525", "3 × 10⁻⁶", "10⁻⁶", "2 × 10⁹"))
  }
}
