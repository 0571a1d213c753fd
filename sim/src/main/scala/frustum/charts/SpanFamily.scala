package frustum.charts

import frustum.synthesis.UnitCosts

/** Affine texture coordinates between exact ones, as spans: a floor seen at a grazing angle, walked into the distance.
  *
  * There is no such hardware in the library, which divides for each pixel: the chart tells what that buys. Cost is
  * divisions a pixel.
  */
object SpanFamily extends ChartFamily {
  val name = "spans"

  private val Texels = 64 * 8 // across the floor's 8 repeats
  private val Length = 256 // pixels from the near end of the floor to the far one
  private val (near, far) = (1.0, 100.0)

  /** Texel at pixel x: the floor's depth has a linear reciprocal. */
  private def texel(x: Double): Double = {
    val w = 1 / (1 / near + (1 / far - 1 / near) * x / Length)
    Texels * (w - near) / (far - near)
  }

  /** Greatest error in texels over the nearest half of the way, where a span is still shorter than a repeat. */
  def error(span: Int): Double = (for {
    start <- 0 until Length / 2 by span
    x <- 0 to span
  } yield {
    val (a, b) = (texel(start), texel(start + span))
    (a + (b - a) * x / span - texel(start + x)).abs
  }).max

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val spans = for (span <- Seq(2, 4, 8, 16, 32, 64))
      yield ChartPoint("affine spans", s"$span pixels", 1.0 / span, error(span))
    val each = ChartPoint("a division for each pixel", "1 pixel", 1, 0)
    Seq(Chart(
      "spans",
      "Affine spans on a grazing floor, 512 texels from depth 1 to 100",
      "divisions a pixel",
      "greatest error, texels",
      spans :+ each,
      Some(each),
      None,
      1e-3,
      "The error grows with the square of the span. Without error is drawn at the lower end.",
      logCost = true
    ))
  }
}
