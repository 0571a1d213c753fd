package frustum.command.common

import me.tongfei.progressbar.{ProgressBar, ProgressBarBuilder}

/** Tells how far long work has come: a bar on a terminal; elsewhere a line a step, or of many steps one in so many that
  * there are at most [[Progress.Lines]] of them.
  */
final class Progress private (name: String, steps: Int, bar: Option[ProgressBar]) extends AutoCloseable {
  private var done = 0

  def step(): Unit = {
    done += 1
    bar.fold(if (Progress.told(done, steps)) println(s"$name: $done of $steps"))(_.step())
  }

  def close(): Unit = bar.foreach(_.close())
}

object Progress {
  val Lines = 20

  def apply(name: String, steps: Int): Progress = {
    val terminal = System.console != null && steps > 1
    new Progress(
      name,
      steps,
      Option.when(terminal)(new ProgressBarBuilder().setTaskName(name).setInitialMax(steps).build())
    )
  }

  /** Whether step `done` of so many has a line: evenly spread, the last always. */
  private[common] def told(done: Int, steps: Int): Boolean =
    steps <= Lines || done * Lines.toLong / steps > (done - 1) * Lines.toLong / steps
}
