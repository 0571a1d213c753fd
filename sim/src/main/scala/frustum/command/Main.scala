package frustum.command

import frustum.boards.flow.FlowFault
import frustum.command.bench.BenchCommand
import frustum.command.bitstream.BitstreamCommand
import frustum.command.budgets.BudgetsCommand
import frustum.command.chart.ChartCommand
import frustum.command.common.{CommandLine, Words}
import frustum.command.demo.DemoCommand
import frustum.command.fit.FitCommand
import frustum.command.mutate.MutateCommand
import frustum.command.play.PlayCommand
import frustum.command.pong.PongCommand
import frustum.command.render.RenderCommand
import frustum.command.report.ReportCommand
import frustum.command.stability.StabilityCommand
import frustum.command.verilog.VerilogCommand
import frustum.command.voxel.VoxelCommand
import frustum.contract.InputError
import scala.util.control.NonFatal

/** Entry of the workbench: the command's name, then its arguments; or `--line` and all of it as one line,
  * quoted as for a shell, which is how the launcher hands on what it was given.
  */
object Main {
  val commands: Seq[CommandLine] =
    Seq(
      DemoCommand,
      RenderCommand,
      VerilogCommand,
      BitstreamCommand,
      BenchCommand,
      PongCommand,
      VoxelCommand,
      PlayCommand,
      BudgetsCommand,
      ChartCommand,
      StabilityCommand,
      FitCommand,
      MutateCommand,
      ReportCommand
    )

  def main(args: Array[String]): Unit = sys.exit(run(args.toSeq))

  /** The exit code. Bad input gives one line on stderr; only faults of our own give a stack trace. */
  def run(args: Seq[String]): Int =
    try args match {
        case Seq("--line", line) => dispatch(Words.split(line))
        case words               => dispatch(words)
      }
    catch {
      case InputError(message) =>
        Console.err.println(s"error: ${message.linesIterator.map(_.trim).mkString(" ")}")
        2
      case FlowFault(message) =>
        Console.err.println(s"error: ${message.linesIterator.map(_.trim).mkString(" ")}")
        1
      case NonFatal(fault) =>
        Console.err.println(s"error: internal fault, please report it: $fault")
        fault.printStackTrace(Console.err)
        1
    }

  private def dispatch(words: Seq[String]): Int = words.headOption match {
    case None | Some("--help") =>
      println("usage: ./sbt \"COMMAND ARGS\"; ./sbt \"COMMAND --help\" tells the arguments")
      commands.foreach(c => println(f"  ${c.name}%-10s ${c.summary}"))
      0
    case Some(name) =>
      commands.find(_.name == name).map(_.run(words.tail)).getOrElse(
        throw InputError(s"there is no command '$name'; choose one of ${commands.map(_.name).mkString(", ")}")
      )
  }
}
