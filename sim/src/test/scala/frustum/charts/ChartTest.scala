package frustum.charts

import frustum.command.CommandRunner
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import javax.imageio.ImageIO

/** Shapes that the charts' data must have, and what the command writes. */
class ChartTest extends AnyFunSuite {
  private def series(chart: Chart, method: String): Seq[Double] =
    chart.points.filter(_.method == method).sortBy(_.cost).map(_.error)

  test("affine spans: the error grows with the square of the span") {
    for (span <- Seq(2, 4, 8)) {
      val ratio = SpanFamily.error(2 * span) / SpanFamily.error(span)
      assert(ratio > 3.5 && ratio < 4.2, s"span $span")
    }
  }

  test("reciprocal: an index bit more halves a table's error and quarters that of a line or a Newton step") {
    val chart = ReciprocalFamily.charts(None).head
    def gain(method: String, n: Int) = { val e = series(chart, method); e(n) / e(n + 1) }
    for (n <- 0 to 6) {
      assert(gain("table", n) > 1.8 && gain("table", n) < 2.2)
      assert(gain("table and line", n) > 3.4 && gain("table and line", n) < 4.6)
      assert(gain("table and Newton step", n) > 3.4 && gain("table and Newton step", n) < 4.6)
    }
    // Measured elsewhere: some 17 bits of a table of 3 kbit and one Newton step.
    val three =
      chart.points.filter(p => p.method == "table and Newton step" && p.cost <= 3.1).map(_.error).min
    assert(ReciprocalFamily.bitsOf(three) > 16.5)
    assert(ReciprocalFamily.bitsOf(chart.shipped.get.error) > 15.9)
  }

  test("depth: OpenGL's z needs gaps in proportion to the range, a reversed float does not") {
    val chart = DepthFamily.charts(None).find(_.name == "depth-range").get
    val z = series(chart, "z of OpenGL, linear on the screen")
    val float = series(chart, "reversed float, 5 bits of exponent")
    assert(z.last / z(3) > 50 && float.last / float(3) < 1.5)
  }

  test("area: each Newton step squares the error until 30 bits end it; three steps are enough") {
    val errors = series(AreaFamily.charts(None).head, "from a line")
    for (n <- 0 to 1) assert(scala.math.abs(errors(n + 1) / (errors(n) * errors(n)) - 1) < 0.1, s"step $n")
    assert(scala.math.abs(errors.head * 17 - 1) < 0.01 && errors(3) < 4e-9 && errors(4) < 4e-9)
  }

  test(
    "roots: a line quarters its error with each index bit; the shade's tables are no worse than a line of as many " +
      "entries"
  ) {
    for (chart <- RootFamily.charts(None)) {
      val line = series(chart, "table and line")
      for (n <- 1 to 3)
        assert(line(n) / line(n + 1) > 2.8 && line(n) / line(n + 1) < 4.6, s"${chart.name}, $n")
      assert(chart.shipped.get.error < 1.5 * line(3), chart.name)
    }
  }

  test("attributes: with all bits next to no texel is wrong, each bit less makes more") {
    for (scene <- Seq("cube", "floor")) {
      val wrong = Seq(0, 4, 8, 12).map(AttributeFamily.wrongPercent(scene, _))
      assert(wrong.head < 0.01 && wrong == wrong.sorted && wrong(2) > 3 * wrong(1), s"$scene: $wrong")
    }
  }

  test("sub-pixel bits: each halves what is wrong") {
    for (bits <- 1 to 5) {
      val ratio = SubpixelFamily.wrongPercent(bits, 1) / SubpixelFamily.wrongPercent(bits + 1, 1)
      assert(ratio > 1.5 && ratio < 2.6, s"$bits bits")
    }
  }

  test(
    "swimming: each sub-pixel bit takes much of it away; with the hardware's 4 it is a fraction of a texel"
  ) {
    val swims = series(SwimFamily.charts(None).head, "cube").tail
    for ((coarse, fine) <- swims.zip(swims.tail)) assert(fine < 0.75 * coarse, swims)
  }

  test(
    "accumulation drifts with the pixels it runs over, by half a unit each at most; a bit more halves it"
  ) {
    for (fraction <- Seq(8, 16)) {
      val drift = AccumulationFamily.error(fraction, AccumulationFamily.Screen) * (1 << fraction)
      assert(drift > 120 && drift <= 160.5, s"$fraction bits: $drift units")
      val tile = AccumulationFamily.error(fraction, 16) * (1 << fraction)
      assert(tile > 6 && tile <= 8.5, s"$fraction bits: $tile units")
    }
  }

  test("filter: a weight's bit halves the error, and cutting costs one") {
    for (bits <- 1 to 6) {
      val ratio = FilterFamily.error(bits, rounded = true) / FilterFamily.error(bits + 1, rounded = true)
      assert(ratio > 1.8 && ratio < 2.2, s"$bits bits")
      assert(
        FilterFamily.error(bits + 1, rounded = false) / FilterFamily.error(bits, rounded = true) > 0.9,
        s"$bits bits"
      )
    }
  }

  test("spheres: a discriminant needs far more bits than the picture; whole numbers have none wrong") {
    val float = Seq(12, 16, 20).map(SphereFamily.floatWrong)
    assert(float == float.sorted.reverse && float.head > 1 && float.last < 0.5, float)
    assert(SphereFamily.floatWrong(53) == 0)
    assert(SphereFamily.unitWrong(8) > SphereFamily.unitWrong(16))
  }

  test("depth: 1/w without regard to the far plane is OpenGL's z with the far plane far away") {
    val bits = DepthFamily.charts(None).find(_.name == "depth-bits").get
    def at(method: String) = series(bits, method)(4)
    assert(
      (at("1/w, without regard to the far plane") / at("z of OpenGL, linear on the screen") - 1).abs < 0.25
    )
  }

  test("tiles: larger ones make more texels wrong") {
    val wrong = Seq((4, 4), (5, 4), (5, 5)).map { case (w, h) => TileFamily.wrongPercent("floor", w, h) }
    assert(wrong == wrong.sorted && wrong.last > wrong.head, wrong)
  }

  test("the front holds what nothing beats, and no more") {
    val Seq(a, b, c, d) = Seq((1, 9), (2, 5), (3, 5), (4, 1)).map { case (cost, error) =>
      ChartPoint("m", s"$cost", cost, error)
    }
    val chart = Chart("n", "t", "c", "e", Seq(d, b, c, a), None, None, 1e-3, "")
    assert(chart.front == Seq(a, b, d))
    val other = Seq(c, d).map(_.copy(method = "other scene"))
    assert(Chart("n", "t", "c", "e", Seq(a, b) ++ other, None, None, 1e-3, "", scenes = true).fronts == Seq(
      Seq(a, b),
      other
    ))
    assert(Chart("n", "t", "c", "e", Seq(a, b) ++ other, None, None, 1e-3, "").front == Seq(a, b, other(1)))
  }

  test("the command writes a page, pictures and data") {
    val out = Files.createTempDirectory("chart")
    val run = CommandRunner.run("chart", "colour", "--no-synthesis", "--out", out.toString)
    assert(run.code == 0, run)
    assert(out.toFile.list().toSet ==
      Set("index.html", "chart.json", "colour-bits.png", "colour-bits.svg", "colour-bits.csv"))
    assert(ImageIO.read(out.resolve("colour-bits.png").toFile).getWidth == 960)
    val points = ujson.read(Files.readString(out.resolve("chart.json")))("charts")(0)("points").arr
    assert(points.count(_("shipped").bool) == 1 && points.exists(_("front").bool))
  }

  for (
    (words, part) <- Seq(
      Seq("chart", "taste") -> "perspective",
      Seq("chart", "--deep") -> "--deep",
      Seq("chart", "systemz") -> "did you mean systems?",
      Seq("chart", "leap") -> "did you mean leaps?",
      Seq("chart", "systems", "--obj", "nothing.obj") -> "nothing.obj",
      Seq("chart", "systems", "--scene", "teepot") -> "teapot",
      Seq("chart", "systems", "--deep") -> "--deep"
    )
  )
    test(s"refused: ${words.mkString(" ")}") {
      val run = CommandRunner.run(words: _*)
      assert(
        run.code == 2 && run.err.length == 1 && run.err.head.startsWith("error: ") && run.err.head.contains(
          part
        ),
        run
      )
    }
}
