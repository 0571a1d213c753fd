package frustum.command

import java.io.ByteArrayOutputStream

/** What a command did: exit code, stdout, and stderr by lines. */
final case class CommandRun(code: Int, out: String, err: Seq[String])

object CommandRunner {
  def run(args: String*): CommandRun = {
    val (out, err) = (new ByteArrayOutputStream, new ByteArrayOutputStream)
    val code = Console.withOut(out)(Console.withErr(err)(Main.run(args)))
    CommandRun(code, out.toString, err.toString.linesIterator.toSeq)
  }
}
