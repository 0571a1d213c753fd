package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** Memory of one tile in two banks: one is drawn to (a read and a write per cycle), the other resolved and cleared.
  * Read data comes one cycle after `readEnable` and holds. Reading a word in the cycle it is written is undefined: the
  * drawing units do not access it, nor the bank that is resolved.
  *
  * @param resolved
  *   whether the resolver reads it; otherwise it is only cleared
  * @param drawnReads
  *   whether the drawing units read it; otherwise `readData` is undefined
  */
case class TileMemory(config: RasterConfig, width: Int, resolved: Boolean, drawnReads: Boolean = true)
    extends Component {
  val addressBits = config.tileLog2Width + config.tileLog2Height
  val io = new Bundle {
    val readEnable = in Bool ()
    val readBank = in UInt (1 bits)
    val readAddress = in UInt (addressBits bits)
    val readData = out Bits (width bits)
    val writeEnable = in Bits (2 bits) // a bit for each bank
    val writeAddress = in UInt (addressBits bits)
    val writeData = in Bits (width bits)
    val clear = slave(TileClear(config))
    val clearValue = in Bits (width bits)
    val resolvedData = resolved generate out(Bits(width bits))
  }

  val data = Vec((0 to 1).map { i =>
    val theirs = io.clear.all || io.clear.active && io.clear.bank === i
    val memory = Mem(Bits(width bits), 1 << addressBits)
    memory.write(
      address = Mux(theirs, io.clear.writeAddress, io.writeAddress),
      data = Mux(theirs, io.clearValue, io.writeData),
      enable = theirs && io.clear.write || io.writeEnable(i)
    )
    if (resolved)
      memory.readSync(
        address = if (drawnReads) Mux(theirs, io.clear.readAddress, io.readAddress) else io.clear.readAddress,
        enable = if (drawnReads) Mux(theirs, io.clear.read, io.readEnable) else io.clear.read
      )
    else memory.readSync(io.readAddress, io.readEnable)
  })

  io.readData := data(RegNextWhen(io.readBank, io.readEnable))
  if (resolved) io.resolvedData := data(io.clear.bank)
}
