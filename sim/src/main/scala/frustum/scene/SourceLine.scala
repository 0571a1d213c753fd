package frustum.scene

import frustum.contract.InputError
import frustum.files.InputFile
import java.nio.charset.StandardCharsets
import java.nio.file.Path

/** A statement of a text file: keyword and arguments, with the place to name when something is wrong with it.
  */
final case class SourceLine(file: Path, number: Int, keyword: String, text: String) {
  val words: IndexedSeq[String] = text.split("\\s+").toIndexedSeq.filter(_.nonEmpty)

  def error(what: String): Nothing = throw InputError(s"$file:$number: $what")

  /** The arguments as finite numbers, `least` to `most` of them. */
  def numbers(least: Int, most: Int, form: String): IndexedSeq[Double] = {
    if (words.length < least || words.length > most)
      error(s"'$keyword' with ${words.length} values; write '$keyword $form'")
    words.map(number)
  }

  def number(word: String): Double = {
    val value =
      word.toDoubleOption.getOrElse(error(s"'$word' is not a number; write '$keyword' with decimal numbers"))
    if (!value.isFinite) error(s"'$word' is not finite; write '$keyword' with finite numbers")
    value
  }
}

object SourceLine {

  /** UTF-8's, which some editors put first, as Latin-1 reads it. */
  private val ByteOrderMark = "\u00ef\u00bb\u00bf"

  /** The statements of a file, without comments (# at the start of a word) and empty lines; a backslash at
    * the end of a line continues it.
    *
    * @param namedBy
    *   who refers to the file and where, for the message when it is missing
    */
  def read(file: Path, namedBy: Option[SourceLine] = None): Seq[SourceLine] = {
    def refuse(message: String): Nothing = namedBy.fold[Nothing](throw InputError(message))(_.error(message))
    val content =
      try InputFile.text(file, "give a readable text file", StandardCharsets.ISO_8859_1)
      catch { case InputError(message) => refuse(message) }
    if (content.contains('\u0000')) refuse(s"$file: is not a text file; give an OBJ or MTL file in text form")
    val lines = content.stripPrefix(ByteOrderMark).split("\r\n|\r|\n", -1).toIndexedSeq
    joined(lines).flatMap { case (number, line) =>
      val text = line.replaceAll("(^|\\s)#.*", "").trim
      Option.when(text.nonEmpty) {
        val keyword = text.takeWhile(!_.isWhitespace)
        SourceLine(file, number, keyword, text.drop(keyword.length).trim)
      }
    }
  }

  private def joined(lines: IndexedSeq[String]): Seq[(Int, String)] = {
    val starts = lines.indices.filter(i => i == 0 || !lines(i - 1).endsWith("\\"))
    starts.zip(starts.drop(1) :+ lines.length).map { case (from, until) =>
      (from + 1, lines.slice(from, until).map(_.stripSuffix("\\")).mkString(" "))
    }
  }
}
