package frustum.raster.link

import spinal.core._

/** What [[CommandDecoder]] did, as pulses of one clock; what they mean is told in [[LinkStatus]]. */
case class DecoderEvents() extends Bundle {
  val accepted, refused, vertexRefused, triangleRefused, incomplete = Bool()
}
