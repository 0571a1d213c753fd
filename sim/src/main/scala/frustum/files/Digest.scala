package frustum.files

import java.security.MessageDigest

/** Names what results are kept under: the first 96 bits of SHA-256 over all that they depend on, in hexadecimal. */
object Digest {
  def apply(parts: Array[Byte]*): String = {
    val sha = MessageDigest.getInstance("SHA-256")
    parts.foreach(sha.update)
    sha.digest().take(12).map("%02x".format(_)).mkString
  }
}
