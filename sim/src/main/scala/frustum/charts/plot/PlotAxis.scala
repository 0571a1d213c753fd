package frustum.charts.plot

import org.jfree.chart.axis.{
  AxisState,
  LogAxis,
  NumberAxis,
  NumberTick,
  NumberTickUnit,
  NumberTickUnitSource,
  TickType,
  ValueAxis
}
import org.jfree.chart.ui.{RectangleEdge, TextAnchor}
import java.awt.Graphics2D
import java.awt.geom.Rectangle2D
import scala.annotation.tailrec
import scala.jdk.CollectionConverters._
import scala.math.{floor, log10, pow}

/** The library's axis for a scale. */
object PlotAxis {
  def apply(label: String, scale: Scale): ValueAxis = {
    val axis = if (scale.log) new DecadesAxis(scale) else evenAxis(scale)
    axis.setLabel(label)
    axis.setRange(scale.start, scale.high)
    axis
  }

  /** Steps of 1, 2 or 5 times a power of ten, of which an axis has 3 to 9: left to itself it chooses steps of which it
    * has two.
    */
  private def evenAxis(scale: Scale): NumberAxis = {
    val axis = new NumberAxis
    val step = new NumberTickUnitSource().getCeilingTickUnit((scale.high - scale.low) / 8).getSize
    axis.setTickUnit(new NumberTickUnit(step) { override def valueToString(v: Double): String = Scale.text(v) })
    axis
  }

  /** A logarithmic axis with numbers between the powers of ten where there is room, as [[LogAxis]] has them at powers
    * of ten alone, of which many an axis has one.
    */
  private final class DecadesAxis(scale: Scale) extends LogAxis {
    override def refreshTicks(
        g: Graphics2D,
        s: AxisState,
        area: Rectangle2D,
        edge: RectangleEdge
    ): java.util.List[_] = {
      val flat = RectangleEdge.isTopOrBottom(edge)
      val anchor = if (flat) TextAnchor.TOP_CENTER else TextAnchor.CENTER_RIGHT
      val font = g.getFontMetrics(getTickLabelFont)
      def half(v: Double) = (if (flat) font.stringWidth(Scale.text(v)) + Between else font.getHeight + 2) / 2.0
      def near(v: Double, w: Double) =
        (valueToJava2D(v, area, edge) - valueToJava2D(w, area, edge)).abs < half(v) + half(w)

      /** All that are as round, while all fit; where there are few numbers yet, those that fit. */
      @tailrec def choose(ranks: List[Seq[Double]], chosen: Seq[Double]): Seq[Double] = ranks match {
        case rank :: rest =>
          val more = rank.foldLeft(chosen)((c, v) => if (c.exists(near(_, v))) c else c :+ v)
          if (more.length < chosen.length + rank.length && chosen.length >= Few) chosen else choose(rest, more)
        case Nil => chosen
      }
      val none = Option.when(scale.zero)(scale.zeroAt).toSeq
      (none.map(_ -> "none") ++ choose(ranks, none).drop(none.length).map(v => v -> Scale.text(v))).map {
        case (v, text) =>
          new NumberTick(TickType.MAJOR, v, text, anchor, TextAnchor.CENTER, 0)
      }.asJava
    }

    /** What may be written, the roundest first. */
    private def ranks: List[Seq[Double]] = {
      val numbers = for {
        power <- floor(log10(scale.low)).toInt to floor(log10(scale.high)).toInt
        twentieths <- 20 until 200
        v = BigDecimal(twentieths) * BigDecimal(10).pow(power) / 20
        if v >= scale.low && v <= scale.high
      } yield twentieths -> v.toDouble
      val rounder = Seq[Int => Boolean](_ == 20, _ == 100, _ == 40, _ % 20 == 0, _ % 10 == 0, _ % 2 == 0, _ => true)
      numbers.groupBy { case (n, _) => rounder.indexWhere(_(n)) }.toList.sortBy(_._1).map(_._2.map(_._2))
    }
  }

  private val Few = 4
  private val Between = 12 // pixels between two numbers side by side
}
