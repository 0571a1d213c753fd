package frustum.scene

import frustum.driver.linear.Vector3
import frustum.files.Notices

/** Reader of the statements `v`, `vt` and `vn` of OBJ files. A position that is no point is refused; whatever else is
  * malformed concerns looks, and is replaced with a notice.
  */
final class ObjVertices(notices: Notices) {
  private type Color = (Double, Double, Double, Double)
  private val White: Color = (1, 1, 1, 1)

  /** Beyond, powers of lengths would leave double precision. */
  private val Farthest = 1e30

  /** Position, and red, green, blue, alpha in 0..1. */
  def position(line: SourceLine): (Vector3, Color) = {
    val n = line.numbersOrNaN(3, 8, "x y z")
    line.copy(text = line.words.take(3).mkString(" ")).numbers(3, 3, "x y z")
    if (n.take(3).exists(_.abs > Farthest)) line.error("a vertex beyond 1e30; scale the mesh down")
    (Vector3(n(0), n(1), n(2)), color(line, n.drop(3)))
  }

  /** After the position: nothing, a weight, a colour, or a colour and its alpha. */
  private def color(line: SourceLine, n: IndexedSeq[Double]): Color = {
    val rgba = n.take(4)
    if (n.length > 4)
      notices.at(line.place, s"'v' with ${n.length + 3} values: what follows x y z r g b a is skipped", "v too long")
    if (n.length < 3) White
    else if (!rgba.forall(_.isFinite)) {
      val remedy = "write 'v x y z r g b' with finite numbers"
      notices.at(line.place, s"a vertex colour that is not finite is white; $remedy", "v colour")
      White
    } else {
      val remedy = "write 'v x y z r g b' with r, g, b in 0..1"
      if (rgba.exists(c => c < -MtlFile.HalfLevel || c > 1 + MtlFile.HalfLevel))
        notices.at(line.place, s"a vertex colour outside 0..1 is clamped; $remedy", "v clamped")
      val c = rgba.map(v => if (v > 1 - MtlFile.HalfLevel) 1 else v.max(0))
      (c(0), c(1), c(2), c.lift(3).getOrElse(1.0))
    }
  }

  /** None where it is not finite. */
  def texture(line: SourceLine): Option[(Double, Double)] = {
    val n = line.numbersOrNaN(1, 3, "u v").take(2)
    val finite = n.forall(_.isFinite)
    val remedy = "its faces show their plain colour; export it anew"
    if (!finite) notices.at(line.place, s"a texture coordinate is not finite: $remedy", "vt")
    Option.when(finite)((n(0), n.lift(1).getOrElse(0.0)))
  }

  /** Of unit length; None where it has no direction. */
  def normal(line: SourceLine): Option[Vector3] = {
    val n = line.numbersOrNaN(3, 3, "x y z")
    val finite = n.forall(_.isFinite)
    if (!finite) notices.at(line.place, "a normal is not finite: its faces' own is taken; export it anew", "vn")
    // to a largest component of 1 first: squares of what a file may hold leave double precision
    val most = n.map(_.abs).max
    Option.when(finite && most > 0)(Vector3(n(0) / most, n(1) / most, n(2) / most).normalized)
  }
}
