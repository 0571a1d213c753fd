package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** How the resolver reads and clears the tile memories, while the other bank is drawn to. All memories follow the same
  * signals; each has its own clear value.
  *
  *   - `active`: bank `bank` belongs to the resolver; `all`: both banks do
  *   - `read`, `write`: enables; the word is written one cycle or more after it was read
  *   - `done`: the bank is clear from the next cycle on
  */
case class TileClear(config: RasterConfig) extends Bundle with IMasterSlave {
  val active, all, read, write, done = Bool()
  val bank = UInt(1 bits)
  val readAddress, writeAddress = UInt(config.tileLog2Width + config.tileLog2Height bits)
  override def asMaster(): Unit = out(active, all, read, write, done, bank, readAddress, writeAddress)
}
