package frustum.engine.raster

/** A frame as an engine drew it.
  *
  * @param image        RGB565, row by row from the top left
  * @param clocks       core clocks of the frame, store loaded, sink always ready
  * @param clocksAtPins core clocks from the first command bit to the last display bit
  * @param busBytes     bytes of the frame's commands on the wire, textures not included
  * @param setUps       triangles set up whole, @param moves triangles moved to a tile; a triangle counts in every pass
  * @param undrawn      triangles that the hardware left out because they face away or have no area, likewise
  */
final case class RenderedFrame(
    image: Array[Int],
    clocks: Option[Long] = None,
    clocksAtPins: Option[Long] = None,
    busBytes: Option[Long] = None,
    setUps: Option[Long] = None,
    moves: Option[Long] = None,
    undrawn: Option[Long] = None
)
