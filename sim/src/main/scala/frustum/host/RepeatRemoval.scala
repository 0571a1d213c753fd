package frustum.host

import frustum.InputError
import frustum.spec.{Domain, Wrap}
import scala.math.floor

/** Takes whole repeats out of texture coordinates: they change no texel, but texel errors grow with the
  * coordinate.
  *
  * A triangle's offset is the multiple of [[RepeatRemoval.Step]] next to its vertex nearest to the eye, where
  * texels are largest. Steps of several repeats, rather than one, because a vertex shared by triangles with
  * different offsets must be sent twice. A mirrored texture repeats after two, so the step is even; a clamped
  * one never: no offset.
  */
object RepeatRemoval {

  /** Repeats; the nearest vertex ends up within half of this of 0. */
  val Step = 4

  /** Repeats to subtract from s and t; InputError when the coordinates exceed the vertex format even so. */
  def offset(triangle: ClipTriangle): (Int, Int) = {
    val nearest = triangle.v.minBy(_.clip.w)
    val offset = (steps(nearest.s, triangle.state.wrapS), steps(nearest.t, triangle.state.wrapT))
    for (
      (name, values) <- Seq("s" -> triangle.v.map(_.s - offset._1), "t" -> triangle.v.map(_.t - offset._2))
    )
      if (!values.forall(_.abs < Domain.MaxRepeats - 1.0 / 65536))
        throw InputError(
          s"a triangle's texture coordinate $name runs from ${values.min} to ${values.max} repeats, " +
            s"counted from its nearest vertex; at most ${Domain.MaxRepeats} either side: " +
            "cut the triangle or repeat the texture less"
        )
    offset
  }

  private def steps(coordinate: Double, wrap: Wrap): Int =
    if (wrap == Wrap.Clamp || coordinate.abs > 1e9) 0 else Step * floor(coordinate / Step + 0.5).toInt
}
