package frustum.raster.store

import frustum.contract.raster.{RasterConfig, StoreLayout}
import spinal.core._
import spinal.lib._

case class StoreCmd(layout: StoreLayout) extends Bundle {
  val write = Bool()
  val address = UInt(layout.addressBits bits) // bank in the most significant bit
  val data = Bits(32 bits)
}

/** Access to the scene store: a read's data comes on `rsp` exactly one cycle after its `cmd` fires, in order. A write
  * stays until it is taken; a read may be withdrawn before.
  */
case class StoreBus(layout: StoreLayout) extends Bundle with IMasterSlave {
  val cmd = Stream(StoreCmd(layout))
  val rsp = Flow(Bits(32 bits))
  override def asMaster(): Unit = { master(cmd); slave(rsp) }
}

/** A frame (or pass) for the rasterizer. */
case class FrameJob(config: RasterConfig) extends Bundle {
  val bank = UInt(1 bits)
  val triangleCount = UInt(config.countBits bits)
  val clearColor = Bits(16 bits)
  val x0, x1, y0, y1 = UInt(5 bits) // tiles, inclusive
}
