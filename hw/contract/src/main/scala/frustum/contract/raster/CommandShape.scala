package frustum.contract.raster

/** Which payload lengths a command of the table may have, derived from its parts. */
object CommandShape {

  /** A repeated part occurs at least once. */
  def lengths(command: Command): Seq[Int] = {
    val fixed = command.parts.filterNot(_.repeated).map(_.layout.words).sum
    command.parts.find(_.repeated) match {
      case None        => Seq(fixed)
      case Some(group) => fixed + group.layout.words to Command.MaxWords by group.layout.words
    }
  }

  def accepts(opcode: Int, length: Int): Boolean =
    Command.all.exists(c => c.opcode == opcode && lengths(c).contains(length))
}
