package frustum.engine

import frustum.peripheral.{SimVideoMonitor, SimVideoReader}

/** Runs a simulated system with a monitor at its pins from frame to frame. The JVM sleeps meanwhile: a frame
  * costs it a few looks.
  *
  * @param divider clocks of a pixel
  * @param run     lets so many clocks pass
  */
final class VideoSession(monitor: SimVideoMonitor, divider: Int = 1)(run: Long => Unit) {
  private val mode = monitor.mode
  private val frameClocks = mode.hTotal.toLong * mode.vTotal * divider
  private var seen = 0L
  val reader = new SimVideoReader(monitor)

  /** Runs until one more frame is complete. Returns at most a [[VideoSession.Looks]]th of a frame after its end:
    * the one that follows is still in its blank or first lines.
    */
  def frame(): Unit = {
    var looks = 0
    while (reader.frames == seen) {
      if (looks > VideoSession.HangFrames * VideoSession.Looks) throw new IllegalStateException(
        s"the monitor hangs: no frame complete in ${VideoSession.HangFrames * frameClocks} clocks, " +
          s"$seen frames so far, ${reader.errors} sync errors"
      )
      run(frameClocks / VideoSession.Looks + 1)
      looks += 1
    }
    seen = reader.frames
  }
}

object VideoSession {
  val Looks = 16

  /** Until lock a system may take up to two frames and its reset. */
  val HangFrames = 4
}
