package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{PackedVertex, RasterConfig, TileRegion}

/** A triangle ready to be stored. */
final case class PackedCorners(
    state: Int,
    v0: PackedVertex,
    v1: PackedVertex,
    v2: PackedVertex,
    pixels: PixelBox
) {
  def vertices: Seq[PackedVertex] = Seq(v0, v1, v2)
}

/** Divides a frame into regions of tiles whose triangles and vertices fit the hardware's store.
  *
  * @param scene what messages call it
  */
final class PassSplitter(config: RasterConfig, scene: String) {

  /** Regions, disjoint and together the whole screen, each with the triangles that touch it in their order.
    * Bands of tile rows first, then columns; InputError when the triangles of one tile are too many.
    */
  def split(triangles: IndexedSeq[PackedCorners]): Seq[(TileRegion, IndexedSeq[PackedCorners])] =
    split(TileRegion.whole(config), triangles)

  private def split(
      region: TileRegion,
      all: IndexedSeq[PackedCorners]
  ): Seq[(TileRegion, IndexedSeq[PackedCorners])] = {
    val here = all.filter(touches(region, _))
    val vertices = here.iterator.flatMap(_.vertices).toSet.size
    if (here.length <= config.maxTriangles && vertices <= config.maxVertices) Seq(region -> here)
    else
      halves(region) match {
        case Some((first, second)) => split(first, here) ++ split(second, here)
        case None                  =>
          throw InputError(
            s"$scene: ${here.length} triangles with $vertices vertices in the tile at pixel " +
              s"(${region.x0 * config.tileWidth}, ${region.y0 * config.tileHeight}); " +
              s"the store holds ${config.maxTriangles} triangles and " +
              s"${config.maxVertices} vertices: draw a simpler mesh or come closer"
          )
      }
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
