package frustum.peripheral

import frustum.contract.raster.RasterConfig
import frustum.video.ResolvedPixel
import spinal.core._
import spinal.core.sim._
import spinal.lib._

/** A sink of pixels as simulated hardware: keeps them with the time they came at in a ring, for the JVM to fetch in
  * bulk.
  *
  * @param entriesLog2 size of the ring
  */
case class SimPixelRecorder(config: RasterConfig, entriesLog2: Int = 17) extends Component {
  val io = new Bundle {
    val pixels = slave(Stream(ResolvedPixel(config)))
    val stall = in Bool ()
    val time = in UInt (36 bits)
    val count = out(UInt(32 bits)).simPublic() // pixels since reset
  }
  val memory = Mem(Bits(64 bits), 1 << entriesLog2).simPublic()
  val count = RegInit(U(0, 32 bits))
  io.pixels.ready := !io.stall
  val entry = io.time ## io.pixels.first ## io.pixels.tileX ## io.pixels.tileY ## io.pixels.color
  memory.write(count.resize(entriesLog2), entry.resize(64), io.pixels.fire)
  when(io.pixels.fire)(count := count + 1)
  io.count := count
}

/** A pixel that was taken, at a clock. */
final case class RecordedPixel(color: Int, first: Boolean, tileX: Int, tileY: Int, time: Long)

object SimPixelRecorder {

  /** Entry `index`, counted from reset; it must still be in the ring. */
  def entry(dut: SimPixelRecorder, index: Long): RecordedPixel = {
    val word = dut.memory.getBigInt(index & ((1L << dut.entriesLog2) - 1)).toLong
    RecordedPixel(
      (word & 0xffff).toInt,
      ((word >> 26) & 1) != 0,
      ((word >> 21) & 31).toInt,
      ((word >> 16) & 31).toInt,
      (word >>> 27)
    )
  }
}
