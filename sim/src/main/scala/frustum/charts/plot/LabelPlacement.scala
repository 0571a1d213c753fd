package frustum.charts.plot

import scala.math.{cos, hypot, sin, toRadians}

/** A rectangle of pixels. */
final case class Frame(x0: Double, y0: Double, x1: Double, y1: Double) {
  def overlaps(o: Frame): Boolean = x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1
  def holds(o: Frame): Boolean = x0 <= o.x0 && y0 <= o.y0 && x1 >= o.x1 && y1 >= o.y1
}

/** Something with a label: its middle, its radius and the size of the text. */
final case class Labelled(x: Double, y: Double, radius: Double, text: String, width: Double, height: Double)

/** Where labels go so that none lies over another or over a point: beside their point, else farther away. */
object LabelPlacement {
  private val Directions =
    Seq(0, 180, 270, 90, 315, 225, 45, 135, 340, 20, 200, 160) // degrees clockwise from the right
  private val Rings = Seq(3, 14, 28, 44, 64) // pixels from the point's border

  /** A rectangle for each; None where there is no room. */
  def apply(labels: Seq[Labelled], within: Frame, taken: Seq[Frame] = Nil): Seq[Option[Frame]] = {
    val points = labels.map(l => Frame(l.x - l.radius, l.y - l.radius, l.x + l.radius, l.y + l.radius))
    labels.foldLeft(Vector.empty[Option[Frame]]) { (placed, label) =>
      placed :+ candidates(label).find(c => within.holds(c) && !(points ++ taken ++ placed.flatten).exists(c.overlaps))
    }
  }

  private def candidates(l: Labelled): Seq[Frame] = for (ring <- Rings; degrees <- Directions) yield {
    val (dx, dy) = (cos(toRadians(degrees)), sin(toRadians(degrees)))
    val (x, y) = (l.x + dx * (l.radius + ring + l.width / 2), l.y + dy * (l.radius + ring + l.height / 2))
    Frame(x - l.width / 2, y - l.height / 2, x + l.width / 2, y + l.height / 2)
  }

  /** Points that lie together, their labels joined, so that each place has one. */
  def joined(labels: Seq[Labelled], near: Double, widthOf: String => Double): Seq[Labelled] =
    labels.foldLeft(Vector.empty[Labelled]) { (groups, l) =>
      groups.indexWhere(g => hypot(g.x - l.x, g.y - l.y) < near) match {
        case -1 => groups :+ l
        case i  =>
          val g = groups(i)
          val text = s"${g.text}, ${l.text}"
          groups.updated(i, g.copy(text = text, width = widthOf(text), radius = g.radius.max(l.radius)))
      }
    }
}
