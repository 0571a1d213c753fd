package frustum.referee

/** What each pixel shows, rows from the top: the scene's triangle of the last opaque fragment and of the last fragment
  * of all, -1 where there is none, and the texel of each, [[Seen.NoTexel]] where there is no texture.
  */
final class Seen(pixels: Int) {
  val opaque, top: Array[Int] = Array.fill(pixels)(-1)
  val opaqueTexel, topTexel: Array[Int] = Array.fill(pixels)(Seen.NoTexel)

  /** A fragment that is drawn at pixel `at`. */
  def write(at: Int, triangle: Int, texel: Int, blended: Boolean): Unit = {
    top(at) = triangle
    topTexel(at) = texel
    if (!blended) { opaque(at) = triangle; opaqueTexel(at) = texel }
  }

  def samePrimitives(o: Seen, at: Int): Boolean = opaque(at) == o.opaque(at) && top(at) == o.top(at)
  def sameTexels(o: Seen, at: Int): Boolean =
    opaqueTexel(at) == o.opaqueTexel(at) && topTexel(at) == o.topTexel(at)
}

object Seen {
  val NoTexel: Int = -1
  def texel(at: Option[(Int, Int)]): Int = at.fold(NoTexel) { case (s, t) => t << 16 | s }
}
