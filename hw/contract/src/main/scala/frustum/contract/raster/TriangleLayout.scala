package frustum.contract.raster

import frustum.contract.{Field, Layout}

/** A triangle on the wire. */
object TriangleLayout extends Layout("triangle", wordBits = 16) {
  val V0 =
    unsigned("v0", bits(0, 13, 4), "index of its first vertex; drawn when v0, v1, v2 turn clockwise on the screen")
  val V1 = unsigned("v1", bits(0, 3, 0) ++ bits(1, 15, 10), "index of its second vertex")
  val V2 = unsigned("v2", bits(1, 9, 0), "index of its third vertex")
}

/** A triangle in the scene store, with its render state and its bounding box in tiles, clipped to the screen. */
object StoredTriangle extends Layout("stored triangle", wordBits = 32) {
  val V0 = add(TriangleLayout.V0.paired)
  val V1 = add(TriangleLayout.V1.paired)
  val V2 = add(TriangleLayout.V2.paired)
  val State = unsigned("state", bits(1, 31, 28), "index of its render state")
  val X0 = unsigned("x0", bits(1, 19, 15), "leftmost column of tiles")
  val X1 = unsigned("x1", bits(1, 14, 10), "rightmost column of tiles")
  val Y0 = unsigned("y0", bits(1, 9, 5), "topmost row of tiles")
  val Y1 = unsigned("y1", bits(1, 4, 0), "lowest row of tiles")

  val corners: Seq[Field] = Seq(V0, V1, V2)
  val box: Seq[Field] = Seq(X0, X1, Y0, Y1)
}
