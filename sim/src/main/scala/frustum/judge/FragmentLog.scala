package frustum.judge

import frustum.model.raster.FragmentProbe
import scala.collection.mutable.ArrayBuilder

/** A covered pixel as the model saw it; `texelS`, `texelT` after wrapping, `depth` 0..65535; `drawn` when it passed the
  * tests of its alpha and depth.
  */
final case class LoggedFragment(
    triangle: Int,
    x: Int,
    y: Int,
    texelS: Int,
    texelT: Int,
    depth: Int,
    drawn: Boolean = true
)

/** Keeps every fragment of one pass, in the order told: what the judges judge. */
final class FragmentLog extends FragmentProbe {
  private val builder = new ArrayBuilder.ofRef[LoggedFragment]

  def fragment(triangle: Int, x: Int, y: Int, texelS: Int, texelT: Int, depth: Int, drawn: Boolean): Unit =
    builder += LoggedFragment(triangle, x, y, texelS, texelT, depth, drawn)

  /** Everything told so far. */
  lazy val fragments: IndexedSeq[LoggedFragment] = builder.result().toIndexedSeq
}
