package frustum.contract.raster

/** A triangle of a frame: three vertex indices and a render state. Drawn if v0, v1, v2 are clockwise on the screen. */
final case class PackedTriangle(state: Int, v0: Int, v1: Int, v2: Int) {

  /** The words of the wire, as [[TriangleLayout]] has them; the command that they are part of names the state. */
  def words: Seq[Int] = TriangleLayout.encode(TriangleLayout.V0 -> v0, TriangleLayout.V1 -> v1, TriangleLayout.V2 -> v2)
}

object PackedTriangle {

  /** The triangle of these words of the wire. */
  def decode(state: Int, words: Seq[Int]): PackedTriangle =
    PackedTriangle(state, TriangleLayout.V0.of(words), TriangleLayout.V1.of(words), TriangleLayout.V2.of(words))
}

/** A rectangle of tiles, both ends inclusive. */
final case class TileRegion(x0: Int, y0: Int, x1: Int, y1: Int)
object TileRegion {
  def whole(c: RasterConfig): TileRegion = TileRegion(0, 0, c.tilesX - 1, c.tilesY - 1)
}

/** What one `begin` .. `draw` sequence draws: a frame, or the part of a frame inside `region`. Several passes with
  * disjoint regions make up a frame that exceeds the store.
  *
  * @param clearColor RGB565; every pixel of the region starts from it, and from the farthest depth
  */
final case class FramePass(
    frame: Int,
    clearColor: Int,
    region: TileRegion,
    states: IndexedSeq[RenderState],
    vertices: IndexedSeq[PackedVertex],
    triangles: IndexedSeq[PackedTriangle]
)

/** Texels for texel memory: `base` in units of 64 texels, row by row from the bottom row (t = 0) up, 16 bits each. */
final case class TextureUpload(base: Int, texels: IndexedSeq[Int])
