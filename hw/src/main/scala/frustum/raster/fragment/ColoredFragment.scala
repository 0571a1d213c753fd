package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import spinal.core._

/** A coloured fragment before the tests: RGB565 and five bits of alpha; its depth is added there. With `tileEnd` it is
  * the tile-end marker, not a pixel, and passes every test.
  */
case class ColoredFragment(config: RasterConfig) extends Bundle {
  val x = UInt(config.tileLog2Width bits)
  val y = UInt(config.tileLog2Height bits)
  val r = UInt(5 bits)
  val g = UInt(6 bits)
  val b = UInt(5 bits)
  val a = UInt(5 bits)
  val tileEnd = Bool()

  /** Word of the tile buffer. */
  def address: UInt = (y ## x).asUInt
}
