package frustum.scene

import frustum.contract.InputError
import java.nio.{ByteBuffer, ByteOrder}
import java.nio.charset.StandardCharsets
import java.nio.file.Path

/** A chunk of a .vox file, read from its start: little-endian numbers, strings and dictionaries, as MagicaVoxel's
  * format has them (github.com/ephtracy/voxel-model). What ends beyond the chunk is refused with its place.
  *
  * @param from,until the chunk's content in the file
  */
final class VoxBytes(file: Path, all: Array[Byte], val kind: String, from: Int, until: Int) {
  private val bytes = ByteBuffer.wrap(all).order(ByteOrder.LITTLE_ENDIAN)
  private var at = from

  def refuse(what: String, place: Int = from): Nothing = throw InputError(s"$file: byte $place: $what")

  private def take(n: Int): Int = {
    if (n < 0 || n > until - at)
      refuse(s"chunk $kind ends after ${until - from} bytes, ${at - from + n.max(0).toLong} are needed; save it again")
    at += n
    at - n
  }

  def int(): Int = bytes.getInt(take(4))
  def float(): Float = bytes.getFloat(take(4))
  def unsignedByte(): Int = bytes.get(take(1)) & 255

  /** A number of things that follow, each of at least `size` bytes. */
  def count(what: String, size: Int): Int = {
    val n = int()
    if (n < 0) refuse(s"$n $what; save it again", at - 4)
    if (n.toLong * size > until - at)
      refuse(s"chunk $kind has ${until - from} bytes, ${at - from + n.toLong * size} are needed; save it again")
    n
  }

  def string(): String = {
    val n = count("bytes of a string", 1)
    new String(all, take(n), n, StandardCharsets.UTF_8)
  }

  def dictionary(): Map[String, String] = Seq.fill(count("entries of a dictionary", 8))(string() -> string()).toMap
}
