package frustum.harness

import java.lang.management.ManagementFactory

/** Processor time of this thread, for tests that promise a speed: what else the machine does is not in it. A simulation
  * evaluates its model in the thread that starts it.
  */
object ThreadTime {
  private val threads = ManagementFactory.getThreadMXBean

  /** Seconds that `body` took, with what it gave. */
  def of[A](body: => A): (Double, A) = {
    val start = threads.getCurrentThreadCpuTime
    val result = body
    ((threads.getCurrentThreadCpuTime - start) / 1e9, result)
  }
}
