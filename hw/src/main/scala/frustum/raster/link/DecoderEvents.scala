package frustum.raster.link

import spinal.core._

/** What [[CommandDecoder]] did, as pulses of one cycle; their meaning is in [[LinkStatus]]. */
case class DecoderEvents() extends Bundle {
  val accepted, refused, vertexRefused, triangleRefused, incomplete = Bool()
}
