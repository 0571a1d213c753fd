package frustum.game

import frustum.InputError
import frustum.model.game.PongButtons
import java.nio.charset.MalformedInputException
import java.nio.file.{Files, NoSuchFileException, Path}
import scala.jdk.CollectionConverters._
import scala.util.control.NonFatal

/** Buttons from a text file, a line a tick: any of `u d l r` (up, down, left, right), or `-` for none. After the
  * last line nothing is pressed.
  */
object ButtonFile {
  private val Letters = "udlr"

  def read(file: Path): IndexedSeq[PongButtons] = {
    val lines =
      try Files.readAllLines(file).asScala.toIndexedSeq
      catch {
        case _: NoSuchFileException     => throw InputError(s"$file: there is no such file; check the name")
        case _: MalformedInputException => throw InputError(s"$file: is not a text file; write lines of u d l r or -")
        case NonFatal(e) =>
          throw InputError(s"$file: cannot be read (${e.getClass.getSimpleName}); give a readable text file")
      }
    lines.zipWithIndex.map { case (line, i) => parse(line.trim, s"$file:${i + 1}") }
  }

  private def parse(line: String, place: String): PongButtons = {
    val letters = line.filterNot(_.isWhitespace)
    if (letters.isEmpty) throw InputError(s"$place: the line is empty; write any of u d l r, or - for no button")
    if (letters != "-")
      letters.find(!Letters.contains(_)).foreach { c =>
        throw InputError(s"$place: '$c' is no button; write any of u d l r, or - alone for no button")
      }
    PongButtons(up = letters.contains('u'), down = letters.contains('d'), left = letters.contains('l'), right = letters.contains('r'))
  }
}
