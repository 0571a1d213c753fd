package frustum.peripheral

import frustum.bus.CommandPins
import frustum.model.raster.link.LinkCounters
import frustum.raster.link.LinkStatus
import spinal.core.sim._

/** A microcontroller's SPI master at the command port, SPI mode 0, as a simulation thread's subroutine.
  *
  * @param halfPeriod of SCK, in units of simulation time
  * @param cts        the slave's answer to "may I send", looked at before each byte
  * @param lateBytes  bytes sent after `cts` has fallen, as a host with a DMA would
  */
final class SpiHost(pins: CommandPins, halfPeriod: Long, cts: () => Boolean, lateBytes: Int = 0) {
  private var late = 0

  /** To be called before the clock starts. */
  def idle(): Unit = {
    pins.sck #= false
    pins.mosi #= false
    pins.cs #= false
    sleep(1)
    pins.cs #= true // simulated logic sees the asynchronous reset by its edge only
    sleep(1)
  }

  /** Sends bytes in one frame of chip select and returns what came on MISO.
    *
    * @param heedCts false: sends on whatever `cts` says
    */
  def send(bytes: Seq[Int], heedCts: Boolean = true): Seq[Int] = frame {
    bytes.map { byte =>
      if (heedCts) waitForCts()
      bits(byte, 8)
    }
  }

  /** Sends a byte's first bits only, then ends the frame. */
  def sendBits(byte: Int, count: Int): Unit = frame(bits(byte, count))

  /** The status bytes of one frame, while nothing but flags is sent. */
  def status(): Seq[Int] = send(Seq.fill(LinkStatus.Bytes)(frustum.contract.raster.Command.Flag), heedCts = false)

  private def frame[A](body: => A): A = {
    pins.cs #= false
    sleep(halfPeriod)
    val result = body
    sleep(halfPeriod)
    pins.cs #= true
    sleep(halfPeriod)
    result
  }

  private def waitForCts(): Unit =
    if (cts()) late = 0
    else if (late < lateBytes) late += 1
    else {
      while (!cts()) sleep(halfPeriod * 2)
      late = 0
    }

  private def bits(byte: Int, count: Int): Int = (0 until count).foldLeft(0) { (got, i) =>
    pins.mosi #= ((byte >> (7 - i)) & 1) != 0
    sleep(halfPeriod)
    val bit = pins.miso.toBoolean
    pins.sck #= true
    sleep(halfPeriod)
    pins.sck #= false
    got << 1 | (if (bit) 1 else 0)
  }
}

object SpiHost {

  /** The counters among the bytes of [[SpiHost.status]]. */
  def counters(status: Seq[Int]): LinkCounters = {
    require(status.length == LinkStatus.Bytes && status.head == LinkStatus.Magic, s"no status: ${status.mkString(" ")}")
    val Seq(a, d, v, t, i, n, u) = status.drop(3)
    LinkCounters(a, d, v, t, i, n, u)
  }
}
