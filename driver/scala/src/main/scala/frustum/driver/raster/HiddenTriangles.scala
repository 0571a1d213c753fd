package frustum.driver.raster

import frustum.contract.raster.{DepthFunction, RenderState}

/** Triangles of a part of the screen of which nothing is seen, because something opaque lies before them at every
  * pixel. Leaving them out changes no pixel. The two sides of a closed mesh need twice the store that the side in
  * front does.
  */
object HiddenTriangles {

  /** Steps of depth, of 65536, by which the nearer must be nearer: more than the hardware's depths are wrong by. */
  val Margin = 64

  /** The triangles that may be seen, in their order.
    *
    * @param box    pixels of the part
    * @param states that the triangles name
    */
  def without(
      triangles: IndexedSeq[PackedCorners],
      box: PixelBox,
      states: IndexedSeq[RenderState]
  ): IndexedSeq[PackedCorners] = {
    val width = box.x1 - box.x0 + 1
    val nearest = Array.fill(width * (box.y1 - box.y0 + 1))(Double.PositiveInfinity)
    def pixels(t: PackedCorners, strictly: Boolean): Iterator[(Int, Double)] = {
      val depth = new DepthPlane(t)
      for (
        y <- (box.y0 to box.y1).iterator;
        (first, last) = PixelCover.columns(t.vertices, y, box.x0, box.x1, strictly);
        x <- (first to last).iterator
      ) yield ((y - box.y0) * width + x - box.x0, depth(x, y))
    }
    for (t <- triangles if hides(states(t.state)); (pixel, depth) <- pixels(t, strictly = true))
      nearest(pixel) = nearest(pixel).min(depth)
    triangles.filter { t =>
      states(t.state).depth != DepthFunction.Less ||
      pixels(t, strictly = false).exists { case (pixel, depth) => depth < nearest(pixel) + Margin }
    }
  }

  /** Whatever is drawn of it takes the place of all behind it. */
  private def hides(s: RenderState): Boolean =
    s.depth == DepthFunction.Less && s.depthWrite && !s.blend && s.alphaRef == 0

  /** Depth at the centres of pixels, which is linear on the screen. */
  private final class DepthPlane(t: PackedCorners) {
    import t.{v0, v1, v2}
    private val (ax, ay, az) = (v1.x - v0.x, v1.y - v0.y, v1.z - v0.z)
    private val (bx, by, bz) = (v2.x - v0.x, v2.y - v0.y, v2.z - v0.z)
    private val area = ax.toDouble * by - ay.toDouble * bx
    private val alongX = (az.toDouble * by - bz.toDouble * ay) / area
    private val alongY = (bz.toDouble * ax - az.toDouble * bx) / area

    def apply(x: Int, y: Int): Double = v0.z + alongX * (16 * x + 8 - v0.x) + alongY * (16 * y + 8 - v0.y)
  }
}
