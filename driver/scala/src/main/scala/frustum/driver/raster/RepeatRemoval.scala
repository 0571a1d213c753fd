package frustum.driver.raster

import frustum.contract.raster.{Domain, PackedVertex, Wrap}
import scala.math.{ceil, floor}

/** Takes whole repeats out of texture coordinates: they change no texel, but texel errors grow with the
  * coordinate.
  *
  * A triangle's offset is the multiple of [[RepeatRemoval.Step]] next to its vertex nearest to the eye, where
  * texels are largest; where another vertex would leave the format that way, the even number next to it that keeps
  * all of them. Steps of several repeats, rather than one, because a vertex shared by triangles with
  * different offsets must be sent twice. A mirrored texture repeats after two, so offsets are even; a clamped
  * one never: no offset.
  *
  * A triangle for which there is no such offset is cut first, at the middle of each edge that has too many repeats.
  * Whether an edge is cut, and where, depends on its two ends alone, so neighbours with the same coordinates along it
  * meet in the new vertex.
  */
object RepeatRemoval {

  /** Repeats; the nearest vertex ends up within half of this of 0. */
  val Step = 4

  /** What the vertex format holds on either side of 0. */
  private val Most = (PackedVertex.MaxSt + 0.5) / 65536

  private def axes(t: ClipTriangle): Seq[(String, Wrap, ClipVertex => Double)] =
    Seq(("s", t.state.wrapS, _.s), ("t", t.state.wrapT, _.t))

  /** Why a triangle cannot be drawn, if so. */
  def fault(triangle: ClipTriangle): Option[String] = axes(triangle).flatMap { case (name, wrap, of) =>
    val values = triangle.v.map(of)
    val clamped = wrap == Wrap.Clamp
    val drawn =
      if (clamped) steps(values, values.head, wrap).isDefined
      else values.forall(_.abs < 1e9) && values.max - values.min <= Domain.MaxMeshRepeats
    Option.unless(drawn)(
      s"texture coordinate $name runs from ${values.min} to ${values.max} repeats; " +
        (if (clamped)
           s"fewer than ${Domain.MaxRepeats / 2} either side of 0 where it is clamped: cut the triangle"
         else s"at most ${Domain.MaxMeshRepeats} within a triangle: cut it or repeat the texture less")
    )
  }.headOption

  /** The triangle, or parts of it that have an offset. */
  def parts(triangle: ClipTriangle): Seq[ClipTriangle] = {
    val along = axes(triangle)
    def tooLong(a: ClipVertex, b: ClipVertex) =
      along.exists { case (_, wrap, of) => steps(Seq(of(a), of(b)), of(a), wrap).isEmpty }
    def repeats(a: ClipVertex, b: ClipVertex) = along.map { case (_, _, of) => (of(a) - of(b)).abs }.max
    val edges = (0 to 2).map(i => (triangle.v(i), triangle.v((i + 1) % 3), triangle.v((i + 2) % 3)))
    // the longest first, which keeps parts from becoming slivers
    edges.filter(e => tooLong(e._1, e._2)).maxByOption(e => repeats(e._1, e._2)).fold(Seq(triangle)) { case (a, b, c) =>
      val m = middle(a, b)
      Seq(IndexedSeq(a, m, c), IndexedSeq(m, b, c)).flatMap(v => parts(triangle.copy(v = v)))
    }
  }

  /** The same whichever end comes first; all attributes are linear in clip space. */
  private def middle(a: ClipVertex, b: ClipVertex): ClipVertex = ClipVertex(
    (a.clip + b.clip) * 0.5,
    (a.s + b.s) / 2,
    (a.t + b.t) / 2,
    (a.rgba + b.rgba) * 0.5
  )

  /** Repeats to subtract from s and t of a part. */
  def offset(triangle: ClipTriangle): (Int, Int) = {
    val nearest = triangle.v.minBy(_.clip.w)
    val Seq(alongS, alongT) = axes(triangle).map { case (name, wrap, of) =>
      steps(triangle.v.map(of), of(nearest), wrap)
        .getOrElse(throw new IllegalStateException(s"driver: $name of $triangle leaves the vertex format"))
    }
    (alongS, alongT)
  }

  /** The offset, None where there is none that keeps all values within the format. */
  private def steps(values: Seq[Double], nearest: Double, wrap: Wrap): Option[Int] = {
    val wanted = if (wrap == Wrap.Clamp) 0 else Step * floor(nearest / Step + 0.5)
    val least = 2 * ceil((values.max - Most) / 2)
    val most = 2 * floor((values.min + Most) / 2)
    val chosen = if (wrap == Wrap.Clamp) wanted else wanted.max(least).min(most)
    Option.when(least <= chosen && chosen <= most)(chosen.toInt)
  }
}
