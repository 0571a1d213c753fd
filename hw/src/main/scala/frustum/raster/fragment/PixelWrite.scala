package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import spinal.core._

/** A fragment for one bank of the tile buffer, or the marker that this bank's tile is complete. */
case class PixelWrite(config: RasterConfig) extends Bundle {
  val address = UInt(config.tileLog2Width + config.tileLog2Height bits)
  val bank = UInt(1 bits)
  val r = UInt(5 bits)
  val g = UInt(6 bits)
  val b = UInt(5 bits)
  val a = UInt(5 bits)
  val tileEnd = Bool()
}
