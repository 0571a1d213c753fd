package frustum.scene

import java.nio.ByteBuffer
import java.nio.charset.StandardCharsets
import java.util.zip.CRC32

/** The checksums of PNG files (ISO/IEC 15948, 5.3 and 5.4), which Java's reader leaves unchecked: a chunk is
  * length, type, data and the CRC of type and data. Those are checked that a picture is made of: the critical
  * chunks, whose type begins with a capital letter, and tRNS, its transparency.
  */
object PngChecksums {
  private val Signature = Seq(0x89, 'P'.toInt, 'N'.toInt, 'G'.toInt, '\r'.toInt, '\n'.toInt, 0x1a, '\n'.toInt)

  /** What is wrong with a file, None for a file of another format. */
  def fault(file: Array[Byte]): Option[String] =
    if (!file.take(Signature.length).map(_ & 255).sameElements(Signature)) None
    else faultFrom(ByteBuffer.wrap(file), Signature.length)

  @annotation.tailrec
  private def faultFrom(file: ByteBuffer, at: Int): Option[String] =
    if (file.limit() - at < 12) None
    else {
      val length = file.getInt(at)
      val kind = new String(file.array, at + 4, 4, StandardCharsets.ISO_8859_1)
      if (length < 0 || length > file.limit() - at - 12) Some(s"its chunk $kind is cut off")
      else if ((kind.head.isUpper || kind == "tRNS") && crc(file, at + 4, 4 + length) != file.getInt(at + 8 + length))
        Some(s"the checksum of its chunk $kind is wrong")
      else if (kind == "IEND") None
      else faultFrom(file, at + 12 + length)
    }

  private def crc(file: ByteBuffer, from: Int, length: Int): Int = {
    val sum = new CRC32
    sum.update(file.array, from, length)
    sum.getValue.toInt
  }
}
