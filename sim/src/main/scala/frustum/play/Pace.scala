package frustum.play

/** Lets frames pass at a steady rate, and no faster. One that is late is not made up for by a hurry of those after it.
  *
  * @param nanos the time now
  * @param sleep waits so many nanoseconds
  */
final class Pace(perSecond: Double, nanos: () => Long = () => System.nanoTime, sleep: Long => Unit = Pace.sleep) {
  private val period = (1e9 / perSecond).toLong
  private var due = Option.empty[Long]

  /** Waits until the next frame is due. */
  def await(): Unit = {
    val now = nanos()
    val at = due.filter(_ > now - Pace.Lag * period).getOrElse(now)
    if (at > now) sleep(at - now)
    due = Some(at + period)
  }
}

object Pace {

  /** Frames by which one may be late and the next still be on time. */
  val Lag = 2

  private def sleep(nanos: Long): Unit = Thread.sleep(nanos / 1000000, (nanos % 1000000).toInt)
}
