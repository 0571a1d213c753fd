package frustum.model.raster.link

import frustum.contract.raster.{Command, CommandShape}
import scala.collection.mutable.ArrayBuffer

/** Bytes of the wire to the commands that are right, see [[frustum.raster.link.Framer]]; there is always room. */
final class Framer {
  private sealed trait State
  private case object Stray extends State
  private case object Skip extends State
  private case object Collect extends State

  private var state: State = Stray
  private var escaped = false
  private val body = ArrayBuffer.empty[Int]

  /** Commands dropped so far. */
  var dropped = 0L

  /** A command, once its last byte has come: opcode and payload words. */
  def take(byte: Int): Option[(Int, Seq[Int])] = {
    require(byte >= 0 && byte < 256, s"byte $byte is outside 0..255")
    if (byte == Command.Flag) {
      if (state == Collect && body.nonEmpty) dropped += 1
      state = Collect
      escaped = false
      body.clear()
      None
    } else if (byte == Command.Escape && !escaped) {
      escaped = true
      None
    } else {
      val data = if (escaped) byte ^ Command.EscapeXor else byte
      escaped = false
      state match {
        case Stray =>
          dropped += 1
          state = Skip
          None
        case Skip    => None
        case Collect =>
          body += data
          if (body.length == 2 && !CommandShape.accepts(body(0), body(1))) {
            dropped += 1
            state = Skip
            None
          } else if (body.length >= 2 && body.length == 2 + 2 * body(1) + 2) finish()
          else None
      }
    }
  }

  private def finish(): Option[(Int, Seq[Int])] =
    if (Command.crc(body.toSeq) == 0) {
      state = Stray
      val words = body.slice(2, body.length - 2).grouped(2).map(p => p(0) << 8 | p(1)).toSeq
      val result = Some((body.head, words))
      body.clear()
      result
    } else {
      dropped += 1
      state = Skip
      None
    }
}
