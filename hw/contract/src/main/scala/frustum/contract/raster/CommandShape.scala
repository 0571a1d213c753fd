package frustum.contract.raster

/** Which payload lengths a command of the table may have, derived from its fields. */
object CommandShape {

  /** A repeated field occurs at least once. */
  def lengths(command: Command): Seq[Int] = {
    val fixed = command.fields.filterNot(_.repeated).map(_.words).sum
    command.fields.find(_.repeated) match {
      case None        => Seq(fixed)
      case Some(group) => fixed + group.words to Command.MaxWords by group.words
    }
  }

  def accepts(opcode: Int, length: Int): Boolean =
    Command.all.exists(c => c.opcode == opcode && lengths(c).contains(length))
}
