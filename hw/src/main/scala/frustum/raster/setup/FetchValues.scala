package frustum.raster.setup

import frustum.contract.raster.RasterConfig
import spinal.core._

/** What [[frustum.contract.raster.FetchProgram]] takes in addition to the store's words. */
case class FetchValues(config: RasterConfig) extends Bundle {
  val tileX, tileY = UInt(5 bits)
  val lastColumn, coveredX = UInt(config.tileLog2Width bits)
  val lastRow, coveredY = UInt(config.tileLog2Height bits)
  val area = UInt(30 bits)
  val place = UInt(5 bits) // the power is 2^(30 - place)
}
