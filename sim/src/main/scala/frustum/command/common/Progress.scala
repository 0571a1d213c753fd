package frustum.command.common

import me.tongfei.progressbar.{ProgressBar, ProgressBarBuilder}

/** Tells how far long work has come: a bar on a terminal, a line a step elsewhere. */
final class Progress private (name: String, steps: Int, bar: Option[ProgressBar]) extends AutoCloseable {
  private var done = 0

  def step(): Unit = {
    done += 1
    bar.fold(println(s"$name: $done of $steps"))(_.step())
  }

  def close(): Unit = bar.foreach(_.close())
}

object Progress {
  def apply(name: String, steps: Int): Progress = {
    val terminal = System.console != null && steps > 1
    new Progress(
      name,
      steps,
      Option.when(terminal)(new ProgressBarBuilder().setTaskName(name).setInitialMax(steps).build())
    )
  }
}
