package frustum.play

import scala.collection.immutable.Queue

/** Frames a second over the last while.
  *
  * @param windowNanos how long back frames count
  */
final class FrameRate(windowNanos: Long = 2000000000L) {
  private var shown = Queue.empty[Long]

  /** A frame was shown at `nanos`. The last two count however long ago the one before was. */
  def frame(nanos: Long): Unit = {
    val all = shown.enqueue(nanos)
    val recent = all.dropWhile(_ < nanos - windowNanos)
    shown = if (recent.size < 2) all.takeRight(2) else recent
  }

  /** 0 before the second frame. */
  def perSecond: Double =
    if (shown.size < 2) 0 else (shown.size - 1) * 1e9 / scala.math.max(1, shown.last - shown.head)
}
