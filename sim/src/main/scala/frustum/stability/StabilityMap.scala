package frustum.stability

import frustum.charts.plot.{Anchor, Canvas, CanvasFiles, Plot, Scale}
import java.awt.Color
import java.nio.file.Path

/** All sweeps as bars, one under the other, each along its own range, with its unit, its ends and where states
  * change.
  */
object StabilityMap {
  val HowToRead: String =
    "Each bar runs through one quantity, evenly by its logarithm (or evenly where it is a whole number): green within the method's bound, yellow beyond it and " +
      "of use, red broken, grey refused. The black line below a bar is the declared domain, the blue one where compared systems work."

  private val colors = Map[Stability, Color](
    Stability.Safe -> new Color(0x4caf6d),
    Stability.Degraded -> new Color(0xf2c14e),
    Stability.Broken -> new Color(0xd64545),
    Stability.Refused -> new Color(0xb8bcc4)
  )
  private val meanings = Seq(
    Stability.Safe -> "within the bound",
    Stability.Degraded -> "beyond it, of use",
    Stability.Broken -> "broken",
    Stability.Refused -> "refused, with a message"
  )
  private val peerBlue = new Color(0x2b6cb0)
  private val ink = new Color(0x222222)
  private val pale = new Color(0x5c636e)

  private val Head = 92
  private val Row = 66
  private val (barLeft, barRight) = (252.0, 672.0)
  private val Words = 690.0 // where the right column begins
  private val Small = 11.5

  /** Writes `map.png` and `map.svg`. */
  def write(folder: Path, results: Seq[SweepResult]): Unit =
    CanvasFiles.write(folder, "map", Plot.Width, Head + Row * results.length + 8)(draw(results, _))

  private def draw(results: Seq[SweepResult], canvas: Canvas): Unit = {
    canvas.text(14, 28, "Where methods fail: each bar runs through one quantity", 17, color = ink, bold = true)
    val states = meanings.map { case (state, words) => (colors(state), 12.0, words) }
    val ranges = Seq((ink, 3.0, "declared domain"), (peerBlue, 3.0, "where compared systems work"))
    (states ++ ranges).foldLeft(14.0) { case (x, (color, thick, words)) =>
      canvas.box(x, 50 - thick / 2, 18, thick, color)
      canvas.text(x + 24, 54, words, Small, color = ink)
      x + 24 + Canvas.widthOf(words, Small) + 18
    }
    canvas.text(14, 80, "quantity, and its unit", Small, color = pale)
    canvas.text(barLeft, 80, "above a bar: where a state begins; below: its ends", Small, color = pale)
    canvas.text(Words, 80, "declared domain; its bound", Small, color = pale)
    for ((r, i) <- results.zipWithIndex) row(r, Head + Row * i, canvas)
  }

  private def row(r: SweepResult, top: Double, canvas: Canvas): Unit = {
    val d = r.sweep.domain
    def x(v: Double) = barLeft + place(r.sweep, v) * (barRight - barLeft)
    canvas.line(14, top, Plot.Width - 14, top, 1, new Color(0xe4e6ea))
    canvas.text(14, top + 27, d.quantity.replace('-', ' '), 13, color = ink, bold = true)
    for ((line, n) <- Canvas.wrapped(d.unit, Small, barLeft - 30).zipWithIndex)
      canvas.text(14, top + 43 + 14 * n, line, Small, color = pale)
    for ((a, b, state) <- r.stretches) canvas.box(x(a), top + 18, (x(b) - x(a)).max(1), 14, colors(state))
    def range(low: Double, high: Double, below: Double, color: Color): Unit = {
      val (a, b) = (x(low), x(high))
      canvas.box(a.min(b - 4), top + below, (b - a).max(4), 3, color)
    }
    range(d.low, d.high, 35, ink)
    for (peer <- r.sweep.peer; (low, high) <- peer.range) range(low, high, 40, peerBlue)
    canvas.text(barLeft, top + 56, Scale.text(rounded(r.sweep.from)), Small, color = ink)
    canvas.text(barRight, top + 56, Scale.text(rounded(r.sweep.to)), Small, Anchor.End, ink)
    r.borders.foldLeft(barLeft - 40) { (taken, b) =>
      val at = x(b.value)
      val words = Seq(s"${Scale.text(rounded(b.value))} ${b.above.name}", Scale.text(rounded(b.value)))
      words.map(w => w -> Canvas.widthOf(w, Small)).collectFirst {
        case (w, width) if at.min(barRight + 10 - width) > taken + 6 => (w, at.min(barRight + 10 - width), width)
      }.fold(taken) { case (w, start, width) =>
        canvas.line(at, top + 14, at, top + 33, 1, ink)
        canvas.text(start, top + 12, w, Small, color = ink)
        start + width
      }
    }
    canvas.text(Words, top + 22, s"${Scale.text(rounded(d.low))} to ${Scale.text(rounded(d.high))}", Small, color = ink)
    canvas.text(Words, top + 38, s"at most ${Scale.text(rounded(d.bound))} ${d.errorUnit}", Small, color = ink)
    for (peer <- r.sweep.peer; (low, high) <- peer.range)
      canvas.text(Words, top + 54, s"others ${Scale.text(rounded(low))} to ${Scale.text(rounded(high))}", Small, color = peerBlue)
  }

  /** Whole numbers as they are, others in three digits. */
  private def rounded(v: Double): Double = if (v.isWhole) v else BigDecimal(v).round(new java.math.MathContext(3)).toDouble

  /** Three digits. */
  def shortest(v: Double): String =
    BigDecimal(v).round(new java.math.MathContext(3)).bigDecimal.stripTrailingZeros match {
      case d if v.abs >= 1e-3 && v.abs < 1e5 => d.toPlainString
      case d                                 => d.toString
    }

  /** 0 to 1 along a sweep. */
  private def place(s: Sweep, v: Double): Double = {
    def clip(x: Double) = x.max(0).min(1)
    if (s.whole) clip((v - s.from) / (s.to - s.from))
    else clip(scala.math.log(v / s.from) / scala.math.log(s.to / s.from))
  }
}
