package frustum.stability

import frustum.charts.plot.{PictureFiles, Plot, Scale}
import org.jfree.chart.text.TextBlockAnchor
import java.awt.geom.Rectangle2D
import java.awt.{Color, Font, Graphics2D}
import java.nio.file.Path

/** All sweeps as bars, one under the other, each along its own range, with its unit, its ends and where states
  * change.
  */
object StabilityMap {
  val HowToRead: String =
    "Each bar runs through one quantity, evenly by its logarithm (or evenly where it is a whole number): green " +
      "within the method's bound, yellow beyond it and of use, red broken, grey refused. The black line below a bar " +
      "is the declared domain, the blue one where compared systems work."

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
  private val small = PictureFiles.font(11.5)

  /** Writes `map.png` and `map.svg`. */
  def write(folder: Path, results: Seq[SweepResult]): Unit =
    PictureFiles.write(folder, "map", Plot.Width, Head + Row * results.length + 8)(new Drawing(_).draw(results))

  private final class Drawing(g: Graphics2D) {
    private def box(x: Double, y: Double, width: Double, height: Double, color: Color): Unit = {
      g.setColor(color)
      g.fill(new Rectangle2D.Double(x, y, width, height))
    }
    private def text(x: Double, y: Double, words: String, color: Color = ink, font: Font = small): Unit = {
      g.setFont(font)
      g.setColor(color)
      g.drawString(words, x.toFloat, y.toFloat)
    }
    private def widthOf(words: String): Double = g.getFontMetrics(small).stringWidth(words).toDouble

    def draw(results: Seq[SweepResult]): Unit = {
      text(14, 28, "Where methods fail: each bar runs through one quantity", font = PictureFiles.font(17, bold = true))
      val states = meanings.map { case (state, words) => (colors(state), 12.0, words) }
      val ranges = Seq((ink, 3.0, "declared domain"), (peerBlue, 3.0, "where compared systems work"))
      (states ++ ranges).foldLeft(14.0) { case (x, (color, thick, words)) =>
        box(x, 50 - thick / 2, 18, thick, color)
        text(x + 24, 54, words)
        x + 24 + widthOf(words) + 18
      }
      text(14, 80, "quantity, and its unit", pale)
      text(barLeft, 80, "above a bar: where a state begins; below: its ends", pale)
      text(Words, 80, "declared domain; its bound", pale)
      for ((r, i) <- results.zipWithIndex) row(r, Head + Row * i)
    }

    private def row(r: SweepResult, top: Double): Unit = {
      val d = r.sweep.domain
      def x(v: Double) = barLeft + place(r.sweep, v) * (barRight - barLeft)
      box(14, top, Plot.Width - 28, 1, new Color(0xe4e6ea))
      text(14, top + 27, d.quantity.replace('-', ' '), font = PictureFiles.font(13, bold = true))
      PictureFiles.wrapped(d.unit, small, pale, barLeft - 30, g)
        .draw(g, 14, (top + 32).toFloat, TextBlockAnchor.TOP_LEFT)
      for ((a, b, state) <- r.stretches) box(x(a), top + 18, (x(b) - x(a)).max(1), 14, colors(state))
      def range(low: Double, high: Double, below: Double, color: Color): Unit = {
        val (a, b) = (x(low), x(high))
        box(a.min(b - 4), top + below, (b - a).max(4), 3, color)
      }
      range(d.low, d.high, 35, ink)
      for (peer <- r.sweep.peer; (low, high) <- peer.range) range(low, high, 40, peerBlue)
      text(barLeft, top + 56, number(r.sweep.from))
      text(barRight - widthOf(number(r.sweep.to)), top + 56, number(r.sweep.to))
      r.borders.foldLeft(barLeft - 40) { (taken, b) =>
        val at = x(b.value)
        val words = Seq(s"${number(b.value)} ${b.above.name}", number(b.value))
        words.map(w => w -> widthOf(w)).collectFirst {
          case (w, width) if at.min(barRight + 10 - width) > taken + 6 => (w, at.min(barRight + 10 - width), width)
        }.fold(taken) { case (w, start, width) =>
          box(at - 0.5, top + 14, 1, 19, ink)
          text(start, top + 12, w)
          start + width
        }
      }
      text(Words, top + 22, s"${number(d.low)} to ${number(d.high)}")
      text(Words, top + 38, s"at most ${number(d.bound)} ${d.errorUnit}")
      for (peer <- r.sweep.peer; (low, high) <- peer.range)
        text(Words, top + 54, s"others ${number(low)} to ${number(high)}", peerBlue)
    }
  }

  /** Whole numbers as they are, others in three digits. */
  private def number(v: Double): String =
    Scale.text(if (v.isWhole) v else BigDecimal(v).round(new java.math.MathContext(3)).toDouble)

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
