package frustum.driver.raster

import frustum.contract.raster.{RasterConfig, VertexRanges}
import frustum.driver.linear.Vector4

/** Cuts triangles in homogeneous clip space, before the division by w.
  *
  * Near and far are cut exactly, always. Left, right, bottom and top are left to the hardware, which visits
  * only tiles of the screen: they are cut only where a vertex would leave the range of the vertex format (the
  * guard band), and then at a plane just inside that range. That makes fewer new vertices, and none on the
  * screen, so no edge of a neighbour meets a new vertex half-way (a T-junction, where pixels would be
  * missed).
  */
final class Clipper(config: RasterConfig) {

  /** Half spaces, positive inside; each linear in the clip coordinates. */
  private type Plane = Vector4 => Double

  private val near: Plane = c => c.w + c.z
  private val far: Plane = c => c.w - c.z
  private val frustum: Seq[Plane] =
    Seq(near, far, c => c.w + c.x, c => c.w - c.x, c => c.w + c.y, c => c.w - c.y)

  /** Pixels from the top left corner of the screen; one step of 1/16 inside what the vertex format holds. */
  private val guardBand = Clipper.guardBand(config.ranges)

  /** x on the screen, times w, pixels. */
  private def screenX(c: Vector4) = (c.w + c.x) * config.width / 2
  private def screenY(c: Vector4) = (c.w - c.y) * config.height / 2
  private val guards: Seq[Plane] = Seq(
    c => guardBand * c.w - screenX(c),
    c => guardBand * c.w + screenX(c),
    c => guardBand * c.w - screenY(c),
    c => guardBand * c.w + screenY(c)
  )

  /** The part of a triangle to draw, a convex polygon in the triangle's direction; empty where nothing is
    * visible.
    */
  def clip(triangle: IndexedSeq[ClipVertex]): IndexedSeq[ClipVertex] =
    if (frustum.exists(plane => triangle.forall(v => plane(v.clip) < 0))) IndexedSeq.empty
    else {
      val byNear = cut(triangle, near, c => c.copy(z = -c.w))
      val byFar = cut(byNear, far, c => c.copy(z = c.w))
      guards.foldLeft(byFar)((polygon, plane) => cut(polygon, plane, identity))
    }

  /** Sutherland and Hodgman's step for one plane. `settle` puts a new vertex exactly onto the plane. */
  private def cut(
      polygon: IndexedSeq[ClipVertex],
      plane: Plane,
      settle: Vector4 => Vector4
  ): IndexedSeq[ClipVertex] =
    if (polygon.forall(v => plane(v.clip) >= 0)) polygon
    else
      polygon.indices.flatMap { i =>
        val (a, b) = (polygon(i), polygon((i + 1) % polygon.length))
        val (da, db) = (plane(a.clip), plane(b.clip))
        // always from the inner end to the outer: both triangles of a shared edge get the very same vertex
        def crossing = {
          val v =
            if (da >= 0) Clipper.between(a, b, da / (da - db)) else Clipper.between(b, a, db / (db - da))
          v.copy(clip = settle(v.clip))
        }
        if (da >= 0) { if (db >= 0 || da == 0) Seq(a) else Seq(a, crossing) }
        else if (db > 0) Seq(crossing)
        else Nil
      }
}

object Clipper {

  def guardBand(ranges: VertexRanges): Double = (ranges.maxXy - 1) / 16.0
  val GuardBand: Double = guardBand(VertexRanges())

  /** The point a fraction f of the way from a to b; all attributes are linear in clip space. */
  def between(a: ClipVertex, b: ClipVertex, f: Double): ClipVertex = ClipVertex(
    a.clip.lerp(b.clip, f),
    a.s + (b.s - a.s) * f,
    a.t + (b.t - a.t) * f,
    a.rgba.lerp(b.rgba, f)
  )
}
