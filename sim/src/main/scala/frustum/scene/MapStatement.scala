package frustum.scene

/** A statement `map_Kd` or `map_d`: a picture, and how it lies on the surface.
  *
  * @param name    of the picture's file as the statement has it; may be empty
  * @param scale   texture coordinates are multiplied by it (`-s`) before `offset` (`-o`) is added
  * @param clamp   `-clamp on`
  * @param channel of `-imfchan`: r, g, b, m (alpha), l (luminance) or z
  * @param skipped options that change nothing here
  */
final case class MapStatement(
    line: SourceLine,
    name: String,
    scale: (Double, Double) = (1, 1),
    offset: (Double, Double) = (0, 0),
    clamp: Boolean = false,
    channel: Option[Char] = None,
    skipped: Seq[String] = Nil
) {
  def coordinates(s: Double, t: Double): (Double, Double) = (s * scale._1 + offset._1, t * scale._2 + offset._2)
}

/** Reader of the options of the MTL format (Wavefront, "Object files", appendix B1). They stand before the name by
  * that document, but after it in some tools' files.
  */
object MapStatement {
  private val Numbers = Map("-s" -> 3, "-o" -> 3, "-t" -> 3, "-mm" -> 2, "-bm" -> 1, "-boost" -> 1, "-texres" -> 1)
  private val Switches = Set("-clamp", "-blendu", "-blendv", "-cc")
  private val Words = Map("-imfchan" -> "[rgbmlz]", "-type" -> "[a-z_]+", "-colorspace" -> "\\S+")
  private val Leading = "(-[A-Za-z]\\w*)(\\s.*|)".r

  def apply(line: SourceLine): MapStatement = {
    val (leading, name) = options(MapStatement(line, ""), line.text)
    if (isFile(line, name)) leading.copy(name = name)
    else {
      // where the rest of the line, from some option on, has nothing but options, they belong to the statement
      val cuts = "\\s-[A-Za-z]".r.findAllMatchIn(name).map(_.start)
      cuts.map(at => (name.take(at).trim, options(leading, name.drop(at).trim)))
        .collectFirst { case (before, (all, "")) => all.copy(name = before) }
        .getOrElse(leading.copy(name = name))
    }
  }

  /** Exactly: options are not mistaken for part of a name. */
  private def isFile(line: SourceLine, name: String): Boolean = NamedFile.find(line, name).exists(_.asWritten)

  /** The statement with the options that `text` begins with, and what follows them. */
  private def options(statement: MapStatement, text: String): (MapStatement, String) = text match {
    case Leading(option, after) if !isFile(statement.line, text) =>
      val (values, rest) = arguments(option.toLowerCase, after.trim)
      options(apply(statement, option.toLowerCase, values), rest)
    case _ => (statement, text)
  }

  private def apply(m: MapStatement, option: String, values: Seq[String]): MapStatement = {
    def pair(other: Double) = (values.lift(0).fold(other)(_.toDouble), values.lift(1).fold(other)(_.toDouble))
    option match {
      case "-s" if values.nonEmpty => m.copy(scale = pair(1))
      case "-o" if values.nonEmpty => m.copy(offset = pair(0))
      case "-clamp"                => m.copy(clamp = values == Seq("on"))
      case "-imfchan"              => m.copy(channel = values.headOption.map(_.head))
      case _                       => m.copy(skipped = m.skipped :+ option)
    }
  }

  /** The option's own arguments, as far as they are there, and the text after them. */
  private def arguments(option: String, text: String): (Seq[String], String) = {
    def number(w: String) = SourceLine.number(w).exists(_.isFinite)
    def switch(w: String) = Set("on", "off")(w.toLowerCase)
    def take(most: Int, text: String)(fits: String => Boolean): (Seq[String], String) = {
      val word = text.takeWhile(!_.isWhitespace)
      if (most == 0 || word.isEmpty || !fits(word)) (Nil, text)
      else {
        val (more, rest) = take(most - 1, text.drop(word.length).trim)(fits)
        (word.toLowerCase +: more, rest)
      }
    }
    if (Numbers.contains(option)) take(Numbers(option), text)(number)
    else if (Switches(option)) take(1, text)(switch)
    else
      Words.get(option) match {
        case Some(form) => take(1, text)(_.toLowerCase.matches(form))
        case None       => take(Int.MaxValue, text)(w => number(w) || switch(w))
      }
  }
}
