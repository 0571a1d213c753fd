package frustum.scene

/** A point of a plane. */
final case class Point2(x: Double, y: Double)
