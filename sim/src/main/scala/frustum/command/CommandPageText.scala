package frustum.command

import frustum.contract.raster.Command
import frustum.raster.link.{Framer, LinkStatus}

/** The parts of [[CommandPage]] that are sentences: framing, flow control, status. */
object CommandPageText {
  private def hex(v: Int): String = f"0x$v%02X"

  private val example = Command.encode(Command.Draw, Seq(3, 1)).map(hex).mkString(" ")

  val framing: Seq[String] = Seq(
    "## On the wire",
    "SPI mode 0, most significant bit first, `host_cs` low while sending. One select may carry any number of " +
      "commands, and a command may be spread over several selects.",
    "```\n" +
      s"${hex(Command.Flag)}  opcode  length  payload: length words of two bytes, high byte first  crc: two bytes, " +
      "high byte first\n" +
      "```",
    s"- After the flag, every byte ${hex(Command.Flag)} or ${hex(Command.Escape)} is sent as ${hex(Command.Escape)} " +
      s"and then the byte xor ${hex(Command.EscapeXor)}. So a flag always starts a command, whatever was lost before " +
      "it. Flags may be repeated as padding.\n" +
      "- `length` counts 16-bit words and fits the command's shape (below); at most " + s"${Command.MaxWords}.\n" +
      "- `crc` is CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF, not reflected, no final xor) over opcode, " +
      "length and payload before escaping; over the bytes \"123456789\" it " +
      "is " + f"0x${Command.crc("123456789".map(_.toInt))}%04X.\n" +
      "- A field that takes more than one word has its upper bits in the first of them.\n" +
      "- A command takes effect only when it is complete and its checksum is right. Anything else is dropped and " +
      "counted as one; the next flag starts afresh.",
    s"`draw` with 3 vertices and 1 triangle, for example: `$example`."
  )

  val flow: Seq[String] = Seq(
    "## Flow control",
    s"`cts` is high while at least ${Framer.MarginWords} words are free in the FIFO behind the port. Up to " +
      s"${Framer.BytesAfterRoom} bytes may still follow after it has fallen, so a host that reads it at least once " +
      s"every ${Framer.BytesAfterRoom} bytes loses nothing. It may stop after any bit and go on later. A host that " +
      "does not read it loses whole commands, each counted.",
    "`cts` stays low while the decoder waits. `begin` waits for a free bank of the store (one frame may be drawn and " +
      "one stored), `texels` until nothing is being drawn. So a host that obeys `cts` needs no other synchronisation."
  )

  /** Byte by byte, as [[LinkStatus.select]] gives them. */
  private val statusBytes = Seq(
    hex(LinkStatus.Magic),
    s"version of this table: ${LinkStatus.Version}",
    "bit 0: a frame is being drawn; bit 1: lowest bit of the frames drawn; bit 2: `cts`; bit 3: an error since " +
      "reset; bit 4: byte 9 counts, which costs cells: not in `icebreaker-raster`",
    "commands accepted",
    "commands dropped: checksum, length, opcode, index, region or address wrong; no room; no frame begun",
    "vertices refused",
    "triangles refused",
    "frames incomplete: `draw` counted otherwise",
    "frames (passes) drawn",
    "triangles left out because they face away or have no area, each once a frame (pass) in which its bounding box " +
      "touches the region"
  )
  require(LinkStatus.Version == 3 && statusBytes.length == LinkStatus.Bytes, "the status has changed: describe it here")

  val status: Seq[String] = Seq(
    "## Status",
    s"`host_miso` sends these ${LinkStatus.Bytes} bytes in every select while the host sends, and continues with " +
      s"byte 2 after the last. To read without sending a command, send flags (${hex(Command.Flag)}). Counters have " +
      s"${LinkStatus.CountBits} bits, start at 0 with reset and wrap at ${1 << LinkStatus.CountBits}: a host that " +
      "reads them after every frame misses nothing. What is read is at most two bytes' time old.",
    (Seq("| byte | content |", "| --- | --- |") ++
      statusBytes.zipWithIndex.map { case (content, at) => s"| $at | $content |" }).mkString("\n")
  )
}
