package frustum.raster.link

import spinal.core._

/** What the host can read on MISO: 9 bytes; all counters start from reset and wrap at 256, so a host that reads them
  * after every frame sees each event; flag 3 stays set, for hosts that read less often.
  *
  * | byte | content |
  * | --- | --- |
  * | 0 | 0xF5 |
  * | 1 | version of this table, 2 |
  * | 2 | flags: bit 0 busy (a frame is being drawn), 1 parity of frames drawn, 2 cts, 3 error (any since reset) |
  * | 3 | commands accepted |
  * | 4 | commands dropped: wrong checksum, length, opcode, index, region or address; no room; no frame begun |
  * | 5 | vertices refused |
  * | 6 | triangles refused |
  * | 7 | frames incomplete |
  * | 8 | frames drawn |
  *
  * While chip select stays low bytes 1 to 8 repeat.
  */
case class LinkStatus() extends Bundle {
  val busy, cts, error = Bool()
  val accepted, dropped, verticesRefused, trianglesRefused, incomplete, drawn = UInt(LinkStatus.CountBits bits)

  /** Byte `at` of the table, modulo 8; byte 1 comes from the slave, so its value here is not used. */
  def select(at: UInt): Bits = {
    val flags = B(0, 4 bits) ## error ## cts ## drawn.lsb ## busy
    val bytes = Seq(drawn.asBits, drawn.asBits, flags) ++
      Seq(accepted, dropped, verticesRefused, trianglesRefused, incomplete).map(_.asBits)
    Vec(bytes)(at)
  }
}

object LinkStatus {
  val Magic = 0xf5
  val Version = 2
  val Bytes = 9
  val CountBits = 8
}
