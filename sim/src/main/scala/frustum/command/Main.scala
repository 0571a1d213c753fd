package frustum.command

import frustum.InputError

/** Entry of the workbench: the command's name, then its arguments. */
object Main {
  val commands: Seq[CommandLine] = Seq(VerilogCommand, BitstreamCommand)

  def main(args: Array[String]): Unit = sys.exit {
    try
      commands.find(c => args.headOption.contains(c.name)).map(_.run(args.toSeq.tail)).getOrElse {
        throw InputError(s"no command '${args.headOption.getOrElse("")}'; choose one of ${commands.map(_.name).mkString(", ")}")
      }
    catch { case InputError(message) => println(s"error: $message"); 2 }
  }
}
