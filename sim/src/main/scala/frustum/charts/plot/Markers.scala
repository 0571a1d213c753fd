package frustum.charts.plot

import java.awt.Color
import scala.math.{Pi, cos, sin, sqrt}

/** The points of each series: a colour and a shape, of the same area for the same radius. */
object Markers {
  def color(series: Int): Color = Plot.Colors(Math.floorMod(series, Plot.Colors.length))

  /** @param radius pixels, of the circle of the same area */
  def apply(canvas: Canvas, series: Int, x: Double, y: Double, radius: Double, hollow: Boolean): Unit = {
    val line = color(series)
    val fill = Some(if (hollow) new Color(255, 255, 255, 200) else new Color(line.getRed, line.getGreen, line.getBlue, 215))

    /** A polygon of so many corners, the first one turned from the right by so much. */
    def regular(corners: Int, turn: Double): Unit = {
      val reach = radius * sqrt(Pi / (corners / 2.0 * sin(2 * Pi / corners)))
      val points = (0 until corners).map { i =>
        val angle = turn + 2 * Pi * i / corners
        (x + reach * cos(angle), y + reach * sin(angle))
      }
      canvas.polygon(points, closed = true, 1.6, line, fill)
    }
    Math.floorMod(series, 5) match {
      case 0 => canvas.circle(x, y, radius, 1.6, line, fill)
      case 1 => regular(4, Pi / 4)
      case 2 => regular(3, -Pi / 2)
      case 3 => regular(4, 0)
      case 4 => regular(3, Pi / 2)
    }
  }
}
