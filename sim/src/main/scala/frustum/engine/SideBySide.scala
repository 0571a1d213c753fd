package frustum.engine

import java.util.concurrent.{ArrayBlockingQueue, TimeUnit}
import scala.util.control.NonFatal

/** Two makers of the same number of results, each in a thread of its own and at most one result ahead of the other. */
object SideBySide {

  /** One side was stopped because the other has failed. */
  private object Stopped extends RuntimeException

  private val PollMillis = 50L

  /** @param first,second hand over their results one by one; `second` runs in the caller's thread
    * @param each          takes the n-th results of both, in order
    * @throws Throwable    of the side that fails first; the other ends with its next result
    */
  def apply[A, B](first: (A => Unit) => Unit, second: (B => Unit) => Unit)(each: (A, B) => Unit): Unit = {
    val results = new ArrayBlockingQueue[Any](1)
    @volatile var stopped = false
    @volatile var failure = Option.empty[Throwable]
    def put(a: A): Unit =
      while (!results.offer(a, PollMillis, TimeUnit.MILLISECONDS)) if (stopped) throw Stopped
    val thread = new Thread(() =>
      try first(put)
      catch { case e: Throwable => failure = Some(e) }
    )
    def take(): A = {
      var taken = results.poll(PollMillis, TimeUnit.MILLISECONDS)
      while (taken == null) {
        // What was put before the thread ended is still there.
        if (!thread.isAlive && results.isEmpty)
          throw failure.getOrElse(new IllegalStateException("one side has fewer results than the other"))
        taken = results.poll(PollMillis, TimeUnit.MILLISECONDS)
      }
      taken.asInstanceOf[A]
    }
    thread.start()
    try second(b => each(take(), b))
    catch {
      // A simulation may wrap what was thrown in it: the cause is the other side's.
      case NonFatal(_) if failure.exists(_ ne Stopped) => throw failure.get
    } finally {
      stopped = true
      thread.join()
    }
    failure.filter(_ ne Stopped).foreach(throw _)
    if (!results.isEmpty) throw new IllegalStateException("one side has more results than the other")
  }
}
