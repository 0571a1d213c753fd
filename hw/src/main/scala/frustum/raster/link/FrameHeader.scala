package frustum.raster.link

import frustum.contract.raster.RasterConfig
import frustum.raster.store.FrameJob
import spinal.core._

/** What [[CommandDecoder]] knows of the frame being filled: `open` from a good `begin` to `draw`.
  *
  * @param word of `begin`, as it came last
  */
class FrameHeader(config: RasterConfig, word: Bits) extends Area {
  val open = RegInit(False)
  val bank = RegInit(False)
  val tag = Reg(Bits(7 bits))
  val clearColor = config.clearColor.fold(Reg(Bits(16 bits)))(B(_, 16 bits))
  val badColor = Bool(config.clearColor.isDefined) && word =/= clearColor
  val region = Reg(Vec.fill(4)(UInt(5 bits))) // x0, x1, y0, y1

  val vertical = Reg(Bool()) // the range in hand is that of y
  val (first, last) = (word(12 downto 8).asUInt, word(4 downto 0).asUInt)
  val lastTile = Mux(vertical, U(config.tilesY - 1, 5 bits), U(config.tilesX - 1, 5 bits))
  val badRange = RegNext((word & 0xe0e0) =/= 0 || first > last || last > lastTile) // of the word a clock ago

  def takeColor(color: Bits): Unit = if (config.clearColor.isEmpty) clearColor := color

  /** Takes a range of tiles; x comes first and is moved on by y. */
  def takeRange(): Unit = {
    region(0) := region(2).resize(config.tileXBits).resized
    region(1) := region(3).resize(config.tileXBits).resized
    region(2) := first
    region(3) := last
    vertical := True
  }

  def fill(job: FrameJob, triangleCount: UInt): Unit = {
    job.bank := bank.asUInt
    job.triangleCount := triangleCount
    job.clearColor := clearColor
    for ((end, value) <- Seq(job.x0, job.x1, job.y0, job.y1).zip(region)) end := value
  }
}
