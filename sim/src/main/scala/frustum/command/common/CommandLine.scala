package frustum.command.common

/** A command of the workbench. `run` gives its exit code: 0 done, 1 a check failed, 2 bad input. */
trait CommandLine {
  def name: String
  def summary: String
  def run(args: Seq[String]): Int
}
