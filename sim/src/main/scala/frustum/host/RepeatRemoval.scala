package frustum.host

import frustum.InputError
import frustum.spec.{Domain, Wrap}
import scala.collection.mutable
import scala.math.{floor, round}

/** Takes whole repeats out of texture coordinates: they change no texel but cost accuracy. Each triangle has its own
  * offset; a vertex shared with a triangle that has another offset must be sent twice, so the offset of a neighbour
  * (or none at all) is taken wherever it leaves the vertex nearest to the eye, where texels are largest, within
  * [[RepeatRemoval.Near]] repeats of 0.
  *
  * A mirrored texture repeats after two, so there offsets are even; a clamped one does not repeat: its offset is 0.
  */
final class RepeatRemoval {
  private val taken = mutable.HashMap.empty[(Double, Double, Double, Double, Double), (Int, Int)]

  /** Offsets in s and t for a triangle; InputError when its coordinates exceed the format even so. */
  def offset(triangle: ClipTriangle): (Int, Int) = {
    val byDistance = triangle.v.sortBy(_.clip.w)
    val nearest    = byDistance.head
    def fits(o: (Int, Int)) = (nearest.s - o._1).abs <= RepeatRemoval.Near && (nearest.t - o._2).abs <= RepeatRemoval.Near
    val candidates = (0, 0) +: byDistance.flatMap(v => taken.get(key(v)))
    val chosen     = candidates.find(o => fits(allowed(o, triangle))).getOrElse(whole(nearest, triangle))
    val offset     = allowed(chosen, triangle)
    triangle.v.foreach(v => taken.update(key(v), offset))
    for ((name, values) <- Seq("s" -> triangle.v.map(_.s - offset._1), "t" -> triangle.v.map(_.t - offset._2)))
      if (!values.forall(_.abs < Domain.MaxRepeats - 1.0 / 65536))
        throw InputError(
          s"a triangle's texture coordinate $name runs from ${values.min} to ${values.max} repeats, counted from its " +
            s"nearest vertex; at most ${Domain.MaxRepeats} either side: cut the triangle or repeat the texture less"
        )
    offset
  }

  private def key(v: ClipVertex) = (v.clip.x, v.clip.y, v.clip.w, v.s, v.t)

  private def whole(v: ClipVertex, triangle: ClipTriangle): (Int, Int) = {
    def one(x: Double, wrap: Wrap) =
      if (x.abs > 1e9) 0 else if (wrap == Wrap.Mirror) 2 * round(x / 2).toInt else floor(x + 0.5).toInt
    (one(v.s, triangle.state.wrapS), one(v.t, triangle.state.wrapT))
  }

  private def allowed(o: (Int, Int), triangle: ClipTriangle): (Int, Int) = {
    def one(offset: Int, wrap: Wrap) = wrap match {
      case Wrap.Clamp  => 0
      case Wrap.Mirror => offset & ~1
      case Wrap.Repeat => offset
    }
    (one(o._1, triangle.state.wrapS), one(o._2, triangle.state.wrapT))
  }
}

object RepeatRemoval {

  /** Repeats the nearest vertex may be away from 0. */
  val Near = 2.0
}
