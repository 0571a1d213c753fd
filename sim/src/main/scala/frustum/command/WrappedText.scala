package frustum.command

/** Markdown wrapped at [[Columns]]: paragraphs and the items of a list; tables, code and headings stay as they are. A
  * code span is never broken.
  */
object WrappedText {
  val Columns = 110

  private val Word = """(?:`[^`]*`|[^\s`])+""".r

  /** @param block one block of the page, without the empty lines around it */
  def apply(block: String): String =
    if (Seq("|", "```", "#").exists(block.startsWith(_))) block
    else block.linesIterator.map(wrap).mkString("\n")

  private def wrap(line: String): String = {
    val indent = if (line.startsWith("- ")) "  " else ""
    Word.findAllIn(line).foldLeft(Vector.empty[String]) { (lines, word) =>
      lines.lastOption match {
        case Some(last) if last.length + 1 + word.length <= Columns => lines.init :+ s"$last $word"
        case Some(_)                                                => lines :+ s"$indent$word"
        case None                                                   => Vector(word)
      }
    }.mkString("\n")
  }
}
