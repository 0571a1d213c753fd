package frustum.host

import frustum.InputError
import frustum.spec.{Domain, PackedVertex, Wrap}
import scala.math.{ceil, floor}

/** Takes whole repeats out of texture coordinates: they change no texel, but texel errors grow with the
  * coordinate.
  *
  * A triangle's offset is the multiple of [[RepeatRemoval.Step]] next to its vertex nearest to the eye, where
  * texels are largest; where another vertex would leave the format that way, the even number next to it that keeps
  * all of them. Steps of several repeats, rather than one, because a vertex shared by triangles with
  * different offsets must be sent twice. A mirrored texture repeats after two, so offsets are even; a clamped
  * one never: no offset.
  */
object RepeatRemoval {

  /** Repeats; the nearest vertex ends up within half of this of 0. */
  val Step = 4

  /** What the vertex format holds on either side of 0. */
  private val Most = (PackedVertex.MaxSt + 0.5) / 65536

  /** Repeats to subtract from s and t; InputError when the coordinates exceed the vertex format even so. */
  def offset(triangle: ClipTriangle): (Int, Int) = {
    val nearest = triangle.v.indices.minBy(triangle.v(_).clip.w)
    def along(name: String, wrap: Wrap, of: ClipVertex => Double) = {
      val values = triangle.v.map(of)
      steps(values, nearest, wrap).getOrElse(
        throw InputError(
          s"a triangle's texture coordinate $name runs from ${values.min} to ${values.max} repeats; " +
            (if (wrap == Wrap.Clamp)
               s"fewer than ${Domain.MaxRepeats / 2} either side of 0 where it is clamped: cut the triangle"
             else s"fewer than ${Domain.MaxRepeats - 2} within a triangle: cut it or repeat the texture less")
        )
      )
    }
    (along("s", triangle.state.wrapS, _.s), along("t", triangle.state.wrapT, _.t))
  }

  /** The offset, None where there is none that keeps all values within the format. */
  private def steps(values: Seq[Double], nearest: Int, wrap: Wrap): Option[Int] = {
    val wanted = if (wrap == Wrap.Clamp) 0 else Step * floor(values(nearest) / Step + 0.5)
    val least  = 2 * ceil((values.max - Most) / 2)
    val most   = 2 * floor((values.min + Most) / 2)
    val chosen = if (wrap == Wrap.Clamp) wanted else wanted.max(least).min(most)
    Option.when(least <= chosen && chosen <= most && chosen.abs < 1e9)(chosen.toInt)
  }
}
