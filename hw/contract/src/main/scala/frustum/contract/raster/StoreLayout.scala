package frustum.contract.raster

/** Where things lie in the scene store, in 32-bit words. The store has two banks: one is filled while the other is drawn.
  *
  *   - vertex i, 5 words at `5 i`: {x, y}, {z, qMantissa}, {qExponent:5, -:2, s:25}, {tag:7, t:25}, {r, g, b, a},
  *     the first-named field in the most significant bits; `tag` is the frame number modulo 128
  *   - triangle i, 2 words at `triangles + 2 i`: {-:2, v0:10, v1:10, v2:10}, {state:4, -:8, x0:5, x1:5, y0:5, y1:5},
  *     the last four being its bounding box in tiles, clipped to the screen
  *   - render state i, 1 word at `states + i`: {first word, second word} of RenderState.words
  */
final case class StoreLayout(config: RasterConfig) {
  val vertexWords: Int = 5
  val triangleWords: Int = 2
  val triangles: Int = vertexWords * config.maxVertices
  val states: Int = triangles + triangleWords * config.maxTriangles
  val bankWords: Int = states + RenderState.Count
  val addressBits: Int = 1 + bankAddressBits
  def bankAddressBits: Int = 32 - Integer.numberOfLeadingZeros(bankWords - 1)
}
