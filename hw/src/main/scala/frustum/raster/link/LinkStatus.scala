package frustum.raster.link

import spinal.core._

/** What the host can read on MISO: 10 bytes; all counters start from reset and wrap at 256, so a host that reads them
  * after every frame sees each event; flag 3 stays set, for hosts that read less often.
  *
  * | byte | content |
  * | --- | --- |
  * | 0 | 0xF5 |
  * | 1 | version of this table, 3 |
  * | 2 | flags: bit 0 busy (drawing), 1 parity of frames drawn, 2 cts, 3 any error since reset, 4 byte 9 counts |
  * | 3 | commands accepted |
  * | 4 | commands dropped: wrong checksum, length, opcode, index, region or address; no room; no frame begun |
  * | 5 | vertices refused |
  * | 6 | triangles refused |
  * | 7 | frames incomplete |
  * | 8 | frames drawn |
  * | 9 | triangles left out since they face away or have no area |
  *
  * In a longer frame of chip select bytes 2 to 9 repeat.
  */
case class LinkStatus() extends Bundle {
  val busy, cts, error, counting = Bool()
  val accepted, dropped, verticesRefused, trianglesRefused, incomplete, drawn, trianglesUndrawn =
    UInt(LinkStatus.CountBits bits)

  /** Byte `at` of the table, modulo 8; bytes 0 and 1 are the slave's own. */
  def select(at: UInt): Bits = {
    val flags = B(0, 3 bits) ## counting ## error ## cts ## drawn.lsb ## busy
    val bytes = Seq(drawn.asBits, trianglesUndrawn.asBits, flags) ++
      Seq(accepted, dropped, verticesRefused, trianglesRefused, incomplete).map(_.asBits)
    Vec(bytes)(at)
  }
}

object LinkStatus {
  val Magic = 0xf5
  val Version = 3
  val Bytes = 10
  val CountBits = 8
}
