package frustum.link

import spinal.core._

/** What the host can read on MISO: 16 bytes, counters little-endian, all counters wrap at 65536 and start from reset.
  *
  * | byte | content |
  * | --- | --- |
  * | 0 | 0xF5 |
  * | 1 | version of this table, 1 |
  * | 2 | flags: bit 0 busy (a frame is being drawn), 1 parity of frames drawn, 2 cts, 3 error (any since reset) |
  * | 3 | 0 |
  * | 4, 5 | commands accepted |
  * | 6, 7 | commands dropped: wrong checksum, length, opcode, index, region or address; no room; no frame begun |
  * | 8, 9 | vertices refused |
  * | 10, 11 | triangles refused |
  * | 12, 13 | frames incomplete |
  * | 14, 15 | frames drawn |
  */
case class LinkStatus() extends Bundle {
  val busy, cts, error = Bool()
  val accepted, dropped, verticesRefused, trianglesRefused, incomplete, drawn = UInt(16 bits)

  /** Bytes 2 n and 2 n + 1 of the table. */
  def select(pair: UInt): (Bits, Bits) = {
    val start = B(LinkStatus.Version << 8 | LinkStatus.Magic, 16 bits)
    val flags = B(0, 12 bits) ## error ## cts ## drawn.lsb ## busy
    val pairs = Seq(start, flags, accepted, dropped, verticesRefused, trianglesRefused, incomplete, drawn)
    val both  = Vec(pairs.map(_.asBits))(pair)
    (both(7 downto 0), both(15 downto 8))
  }
}

object LinkStatus {
  val Magic   = 0xf5
  val Version = 1
  val Bytes   = 16
}
