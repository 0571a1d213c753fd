package frustum.peripheral

import spinal.core.sim._

/** What a [[SimVideoMonitor]] measured of one kind: its last value, how often it was measured and how often wrong. */
final case class VideoMeasure(name: String, last: Long, measured: Long, wrong: Long, lastWrong: Long)

/** Takes frames and measurements from a monitor while the simulation stands still. */
final class SimVideoReader(dut: SimVideoMonitor) {
  private val words = dut.mode.width * dut.mode.height / SimVideoMonitor.Lanes

  /** Complete frames so far; the last stays readable until the next is complete. */
  def frames: Long = dut.io.frames.toLong

  /** Since the monitor has locked; 0 means that every pulse, porch and total had its clocks. */
  def errors: Long = dut.io.errors.toLong

  /** Clocks from the last vertical pulse but one to the last. */
  def clocksPerFrame: Long = dut.vTotal.last.toLong

  /** Colours of the last complete frame as they stood at the pins. */
  def picture(): Array[Int] = {
    require(frames > 0, "no frame is complete")
    val base = if (frames % 2 == 1) 0 else words
    val picture = new Array[Int](words * SimVideoMonitor.Lanes)
    for (w <- 0 until words) unpack(dut.memory.getBigInt(base + w).toByteArray, picture, w * SimVideoMonitor.Lanes)
    picture
  }

  /** The pixels of one word, the first in its lowest bits.
    *
    * @param bytes big-endian, as many as it takes
    */
  private def unpack(bytes: Array[Byte], picture: Array[Int], from: Int): Unit = {
    var (held, bits, pixel) = (0L, 0, 0)
    var next = bytes.length - 1
    while (pixel < SimVideoMonitor.Lanes) {
      while (bits < dut.colorBits) {
        if (next >= 0) held |= (bytes(next) & 0xffL) << bits
        next -= 1
        bits += 8
      }
      picture(from + pixel) = (held & ((1 << dut.colorBits) - 1)).toInt
      held >>>= dut.colorBits
      bits -= dut.colorBits
      pixel += 1
    }
  }

  def measures: Seq[VideoMeasure] =
    dut.intervals.map { case (name, i) =>
      VideoMeasure(name, i.last.toLong, i.measured.toLong, i.wrong.toLong, i.lastWrong.toLong)
    } ++ dut.counts.map { case (name, n) => VideoMeasure(name, 0, 0, n.toLong, 0) }
}
