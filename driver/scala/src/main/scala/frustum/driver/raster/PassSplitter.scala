package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{PackedVertex, RasterConfig, RenderState, TileRegion}

/** A triangle ready to be stored.
  *
  * @param pixels whose centres lie in its bounding box
  * @param source which triangle of the scene it is, or is a part of
  * @param back   its back is seen
  */
final case class PackedCorners(
    state: Int,
    v0: PackedVertex,
    v1: PackedVertex,
    v2: PackedVertex,
    pixels: PixelBox,
    source: Int = 0,
    back: Boolean = false
) {
  def vertices: Seq[PackedVertex] = Seq(v0, v1, v2)
}

/** Divides a frame into regions of tiles whose triangles and vertices fit the hardware's store. A region is at
  * least a tile. Where one has too much for the store it is given only those triangles that cover the centre of one
  * of its pixels, and of these, if need be, only those of which something may be seen: of a dense mesh few.
  *
  * @param states that the triangles name
  * @param scene  what messages call it
  */
final class PassSplitter(config: RasterConfig, states: IndexedSeq[RenderState], scene: String) {

  /** Regions, disjoint and together the whole screen, each with the triangles that touch it in their order.
    * Bands of tile rows first, then columns; InputError when the triangles of one tile are too many, with what would
    * help.
    */
  def split(triangles: IndexedSeq[PackedCorners]): Seq[(TileRegion, IndexedSeq[PackedCorners])] =
    split(TileRegion.whole(config), triangles)

  private def split(
      region: TileRegion,
      all: IndexedSeq[PackedCorners]
  ): Seq[(TileRegion, IndexedSeq[PackedCorners])] = {
    val here = all.filter(touches(region, _))
    if (fits(here)) Seq(region -> here)
    else
      halves(region) match {
        case Some((first, second)) => split(first, here) ++ split(second, here)
        case None                  =>
          val covering = here.filter(t => PixelCover.covers(t.vertices, overlap(region, t)))
          val seen = mayBeSeen(region, covering)
          if (!fits(seen)) refuse(region, covering)
          Seq(region -> seen)
      }
  }

  /** All of them where there is room. */
  private def mayBeSeen(tile: TileRegion, triangles: IndexedSeq[PackedCorners]): IndexedSeq[PackedCorners] =
    if (fits(triangles)) triangles else HiddenTriangles.without(triangles, pixels(tile), states)

  private def vertices(triangles: IndexedSeq[PackedCorners]): Int = triangles.iterator.flatMap(_.vertices).toSet.size

  private def fits(triangles: IndexedSeq[PackedCorners]): Boolean =
    triangles.length <= config.maxTriangles && vertices(triangles) <= config.maxVertices

  private def refuse(tile: TileRegion, triangles: IndexedSeq[PackedCorners]): Nothing = {
    val front = triangles.filterNot(_.back)
    val cull =
      if (front.length == triangles.length) ""
      else
        s"--cull back leaves ${front.length} of them with ${vertices(front)} vertices" +
          (if (fits(mayBeSeen(tile, front))) "; " else ", too many as well; ")
    throw InputError(
      s"$scene: ${triangles.length} triangles with ${vertices(triangles)} vertices in the tile at pixel " +
        s"(${tile.x0 * config.tileWidth}, ${tile.y0 * config.tileHeight}), in a pass of its own; " +
        s"the store holds ${config.maxTriangles} triangles and ${config.maxVertices} vertices: ${cull}" +
        "a larger picture (--size) or an eye that is closer spreads them over more tiles; or draw a simpler mesh"
    )
  }

  private def pixels(r: TileRegion): PixelBox = PixelBox(
    r.x0 * config.tileWidth,
    r.y0 * config.tileHeight,
    ((r.x1 + 1) * config.tileWidth).min(config.width) - 1,
    ((r.y1 + 1) * config.tileHeight).min(config.height) - 1
  )

  private def overlap(r: TileRegion, t: PackedCorners): PixelBox = {
    val (b, p) = (t.pixels, pixels(r))
    PixelBox(b.x0.max(p.x0), b.y0.max(p.y0), b.x1.min(p.x1), b.y1.min(p.y1))
  }

  private def touches(r: TileRegion, t: PackedCorners): Boolean = {
    val b = t.pixels
    b.x0 < (r.x1 + 1) * config.tileWidth && b.x1 >= r.x0 * config.tileWidth &&
    b.y0 < (r.y1 + 1) * config.tileHeight && b.y1 >= r.y0 * config.tileHeight
  }

  private def halves(r: TileRegion): Option[(TileRegion, TileRegion)] = {
    val (midX, midY) = ((r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2)
    if (r.y1 > r.y0) Some((r.copy(y1 = midY), r.copy(y0 = midY + 1)))
    else if (r.x1 > r.x0) Some((r.copy(x1 = midX), r.copy(x0 = midX + 1)))
    else None
  }
}
