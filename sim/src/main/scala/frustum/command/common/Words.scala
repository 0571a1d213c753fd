package frustum.command.common

import frustum.contract.InputError

/** Splits a command line into words at blanks. Quotes, single or double, keep blanks; outside single quotes a
  * backslash takes the next character as it is.
  */
object Words {
  def split(line: String): Seq[String] = {
    val words = Seq.newBuilder[String]
    val word = new StringBuilder
    var open = false // a word has begun, perhaps an empty one in quotes
    var quote: Char = 0
    val characters = line.iterator
    while (characters.hasNext) characters.next() match {
      case '\\' if quote != '\'' && characters.hasNext => word += characters.next(); open = true
      case c if quote != 0 && c == quote               => quote = 0
      case c if quote == 0 && (c == '"' || c == '\'')  => quote = c; open = true
      case c if quote == 0 && c.isWhitespace           => if (open) words += word.result(); word.clear(); open = false
      case c                                           => word += c; open = true
    }
    if (quote != 0) throw InputError(s"the quote $quote is not closed in: $line")
    if (open) words += word.result()
    words.result()
  }
}
