package frustum.contract.raster

import frustum.contract.Layout

/** The payload of `begin`. */
object BeginLayout extends Layout("begin", wordBits = 16) {
  private val tiles = "0 and up from the top left; 16 x 16 pixels each in the tops"

  val Frame = unsigned(
    "frame",
    word(0),
    "frame number, of which the lower 7 bits count, another for each frame: vertices sent under another number are " +
      "not drawn"
  )
  val ClearColor = unsigned("clearColor", word(1), "RGB565")
  val X0 = unsigned("x0", bits(2, 15, 8), s"leftmost column of tiles to draw, $tiles")
  val X1 = unsigned("x1", bits(2, 7, 0), "rightmost column to draw, inclusive")
  val Y0 = unsigned("y0", bits(3, 15, 8), "topmost row of tiles to draw")
  val Y1 = unsigned("y1", bits(3, 7, 0), "lowest row to draw, inclusive")
}

/** The first word of `state`; the state follows. */
object StateHeadLayout extends Layout("state", wordBits = 16) {
  val Index = unsigned("index", word(0), s"0 to ${RenderState.Count - 1}")
}

/** The first word of `vertices`; the vertices follow. */
object VerticesHeadLayout extends Layout("vertices", wordBits = 16) {
  val First = unsigned("first", word(0), "index of the first vertex, 0 to 1023")
}

/** The first word of `triangles`; the triangles follow. */
object TrianglesHeadLayout extends Layout("triangles", wordBits = 16) {
  val State = unsigned("state", word(0), s"render state of these triangles, 0 to ${RenderState.Count - 1}")
}

/** The first word of `texels`; the texels follow. */
object TexelsHeadLayout extends Layout("texels", wordBits = 16) {

  /** Texels in a unit of the address. */
  val Unit = 16

  val Address = unsigned("address", word(0), s"first texel / $Unit")
}

object TexelLayout extends Layout("texel", wordBits = 16) {
  val Texel = unsigned("texel", word(0), "RGB565 or RGBA4444")
}

/** The payload of `draw`: what was sent. */
object DrawLayout extends Layout("draw", wordBits = 16) {
  val Vertices = unsigned("vertices", word(0), "vertices sent since begin")
  val Triangles = unsigned("triangles", word(1), "triangles sent since begin")
}
