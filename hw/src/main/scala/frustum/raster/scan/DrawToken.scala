package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._

/** What starts the drawing of a triangle's part in a tile, or ends the tile.
  *
  * The planes' values at the first pixel of the first span, whose column is `x`, are in the slot's entry `parity`.
  */
case class DrawToken(config: RasterConfig) extends Bundle {
  val tileEnd = Bool()
  val state = UInt(4 bits) // render state index
  val slot = UInt(log2Up(config.slots) bits)
  val parity = Bool()
  val x = UInt(config.tileLog2Width bits)
}
