package frustum.scene

import frustum.contract.InputError
import java.nio.file.Path

/** A statement of an OBJ or MTL file, with the place to name when something is wrong with it.
  *
  * @param name as it is written
  * @param text what follows it, without a comment
  */
final case class SourceLine(file: Path, number: Int, name: String, text: String) {

  /** The name in lower case. */
  val keyword: String = name.toLowerCase

  lazy val words: IndexedSeq[String] = text.split("\\s+").toIndexedSeq.filter(_.nonEmpty)

  def place: String = s"$file:$number"

  def error(what: String): Nothing = throw InputError(s"$place: $what")

  /** The arguments as finite numbers, `least` to `most` of them. */
  def numbers(least: Int, most: Int, form: String): IndexedSeq[Double] = {
    val values = numbersOrNaN(least, most, form)
    values.zip(words).find(!_._1.isFinite).foreach { case (_, word) =>
      error(s"'$word' is not finite; write '$name' with finite numbers")
    }
    values
  }

  /** The same; infinities and what is not a number in any of the spellings that are in use may be among them. */
  def numbersOrNaN(least: Int, most: Int, form: String): IndexedSeq[Double] = {
    if (words.length < least || words.length > most)
      error(s"'$name' with ${words.length} values; write '$name $form'")
    words.map(SourceLine.number(_).getOrElse {
      val word = words.find(SourceLine.number(_).isEmpty).get
      error(s"'$word' is not a number; write '$name' with decimal numbers")
    })
  }
}

object SourceLine {

  /** Of the C libraries of Unix ("-nan", "inf") and of Windows ("1.#QNAN", "-1.#IND", "1.#INF"). */
  private val NotFinite = "(?i)[+-]?(nan.*|inf(inity)?|1\\.#[a-z]+0*)".r

  def number(word: String): Option[Double] =
    if (NotFinite.matches(word)) Some(Double.NaN)
    // Java's own grammar has suffixes and hexadecimal as well
    else if (word.exists(c => c.isLetter && c != 'e' && c != 'E')) None
    else word.toDoubleOption

  /** Statements whose argument is a name, in which # and a backslash at the end may stand. */
  private def named(keyword: String): Boolean = Names(keyword) || keyword.startsWith("map_")
  private val Names =
    Set(
      "g",
      "o",
      "usemtl",
      "newmtl",
      "mtllib",
      "usemap",
      "maplib",
      "shadow_obj",
      "trace_obj",
      "bump",
      "disp",
      "decal",
      "refl"
    )

  /** The statements of a file without comments and empty lines. A line that begins with # is a comment to its end,
    * whatever that is; elsewhere # begins one at the start of a word, but not in names. A backslash at the end of
    * a statement, blanks after it or not, continues it on the next line; in a name it does so after a blank.
    *
    * InputError naming the file where it cannot be read.
    */
  def read(file: Path): Seq[SourceLine] = {
    val lines = SourceText.lines(file).iterator.zipWithIndex
    val statements = Seq.newBuilder[SourceLine]
    while (lines.hasNext) {
      val (first, index) = lines.next()
      val name = first.trim.takeWhile(!_.isWhitespace).stripSuffix("\\")
      val keyword = name.toLowerCase
      val text = new StringBuilder
      var part = withoutComment(first, keyword)
      while (continues(part, keyword) && lines.hasNext) {
        text ++= part.dropRight(1) += ' '
        part = withoutComment(lines.next()._1, keyword)
      }
      text ++= (if (continues(part, keyword)) part.dropRight(1) else part)
      val statement = text.result().trim
      if (statement.nonEmpty) statements += SourceLine(file, index + 1, name, statement.drop(name.length).trim)
    }
    statements.result()
  }

  private def withoutComment(line: String, keyword: String): String = {
    val text = line.trim
    if (text.startsWith("#")) ""
    else if (named(keyword) || text.indexOf('#') < 0) text
    else text.replaceFirst("\\s#.*", "").trim
  }

  private def continues(text: String, keyword: String): Boolean =
    text.endsWith("\\") && (!named(keyword) || text.dropRight(1).lastOption.forall(_.isWhitespace))
}
