package frustum.raster.texture

import spinal.core._
import spinal.lib._

/** Ports of a perspective divide: [[PerspectiveDivide]], or [[LateDivide]] where a scene's depths allow it. */
case class DivideIo() extends Bundle {
  val up = slave(Stream(ProjectiveCoordinate()))
  val down = master(Stream(TextureCoordinate()))
  val busy = out Bool ()
}
