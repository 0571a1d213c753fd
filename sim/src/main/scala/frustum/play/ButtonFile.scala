package frustum.play

import frustum.contract.InputError
import frustum.files.InputFile
import frustum.model.demos.pong.PongButtons
import java.nio.file.Path

/** Buttons from a text file, a line a tick: any of `u d l r` (up, down, left, right), or `-` for none. After the
  * last line nothing is pressed.
  */
object ButtonFile {
  private val Letters = "udlr"

  def read(file: Path): IndexedSeq[PongButtons] = {
    val lines = InputFile.text(file, "write lines of u d l r or -").linesIterator
    lines.toIndexedSeq.zipWithIndex.map { case (line, i) => parse(line.trim, s"$file:${i + 1}") }
  }

  private def parse(line: String, place: String): PongButtons = {
    val letters = line.filterNot(_.isWhitespace)
    if (letters.isEmpty)
      throw InputError(s"$place: the line is empty; write any of u d l r, or - for no button")
    if (letters != "-")
      letters.find(!Letters.contains(_)).foreach { c =>
        throw InputError(s"$place: '$c' is no button; write any of u d l r, or - alone for no button")
      }
    PongButtons(
      up = letters.contains('u'),
      down = letters.contains('d'),
      left = letters.contains('l'),
      right = letters.contains('r')
    )
  }
}
