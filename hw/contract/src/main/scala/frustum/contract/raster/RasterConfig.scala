package frustum.contract.raster

import frustum.contract.video.ScreenTiles

/** Sizes of a raster pipeline. All of them are elaboration parameters; the command set does not depend on them.
  *
  * @param width,height screen, pixels; the frame is drawn tile by tile, so any size costs the same memory
  * @param tileLog2Width,tileLog2Height tile, 2^n pixels a side
  * @param fixed   the constant part of a render state, for which nothing is built
  * @param formats bits that attribute planes go without
  * @param ranges  of the vertices' numbers
  * @param slots   triangles that stay set up from tile to tile
  * @param clearColor RGB565, if all frames begin with this one; hardware then keeps none
  * @param walker  how many edges of a triangle the walker moves at once
  * @param countUndrawn whether triangles that face away or have no area are counted for the host
  */
final case class RasterConfig(
    width: Int = 240,
    height: Int = 320,
    tileLog2Width: Int = 4,
    tileLog2Height: Int = 4,
    maxVertices: Int = 1024,
    maxTriangles: Int = 1024,
    textureTexels: Int = 32768,
    fixed: FixedState = FixedState.None,
    formats: PlaneFormats = PlaneFormats(),
    ranges: VertexRanges = VertexRanges(),
    clearColor: Option[Int] = None,
    slots: Int = 6,
    walker: WalkerKind = WalkerKind.Serial,
    countUndrawn: Boolean = true
) extends ScreenTiles {
  require(tileLog2Width >= 3 && tileLog2Width <= 5, s"tile width 2^$tileLog2Width is outside 8..32")
  require(tileLog2Height >= 3 && tileLog2Height <= 5, s"tile height 2^$tileLog2Height is outside 8..32")
  val tileWidth: Int = 1 << tileLog2Width
  val tileHeight: Int = 1 << tileLog2Height
  val tilesX: Int = (width + tileWidth - 1) / tileWidth
  val tilesY: Int = (height + tileHeight - 1) / tileHeight
  require(width >= 8 && height >= 8, s"screen $width x $height is smaller than 8 x 8")
  require(tilesX <= 32, s"screen width $width needs $tilesX tiles of $tileWidth; at most 32")
  require(tilesY <= 32, s"screen height $height needs $tilesY tiles of $tileHeight; at most 32")
  require(maxVertices >= 3 && maxVertices <= 1024, s"$maxVertices vertices: 3..1024, an index has 10 bits")
  require(maxTriangles >= 1 && maxTriangles <= 1024, s"$maxTriangles triangles: 1..1024")
  private def bitsFor(values: Int): Int = 32 - Integer.numberOfLeadingZeros(values - 1)

  /** Of a tile's column. */
  def tileXBits: Int = bitsFor(tilesX).max(1)

  /** Of a vertex' and a triangle's index, and of a number of triangles. */
  def vertexBits: Int = bitsFor(maxVertices)
  def triangleBits: Int = bitsFor(maxTriangles).max(1)
  def countBits: Int = bitsFor(maxTriangles + 1)
  require(
    width <= (1 << ranges.position) && height <= (1 << ranges.position),
    s"screen of $width x $height, positions below 2^${ranges.position} pixels"
  )
  require(clearColor.forall(c => c >= 0 && c <= 0xffff), s"clear colour $clearColor is not RGB565, 0..65535")
  require(slots >= 3 && slots <= 6, s"$slots slots; from 3 (two are drawn, one is set up) to 6")
  require(textureTexels >= 64 && textureTexels <= 32768, s"$textureTexels texels: 64..32768")
}
