package frustum.engine.raster

import frustum.engine.EngineSim
import frustum.peripheral.{SimTftReader, TftController}
import spinal.core.sim._

/** Talks to a running [[PinsTestbed]]: bytes through the host, pictures from the display's memory. To be made first
  * thing in the simulation.
  */
final class PinsSession(dut: PinsTestbed) {
  import PinsSession._
  private val modulus = 1L << (PinsTestbed.RingLog2 + 1)
  private val ring = 1L << PinsTestbed.RingLog2
  private var queued = 0L
  val controller = new TftController(dut.panel)
  private val reader = new SimTftReader(dut.tft, controller, (PinsTestbed.CoreMHz * 1000000).toLong, PinsTestbed.Fast)

  dut.io.queued #= 0
  dut.io.frameStart #= 0
  dut.io.tftMux #= false
  dut.io.dc #= false
  dut.io.run #= true
  dut.clockDomain.forkStimulus(EngineSim.Period)
  dut.clockDomain.waitSampling(20)
  reset()

  /** Pulls the reset pin. Bytes that were not sent yet will be sent afterwards. */
  def reset(): Unit = {
    dut.io.run #= false // an edge: simulated logic sees an asynchronous reset by nothing else
    dut.clockDomain.waitSampling(20)
    dut.io.run #= true
    dut.clockDomain.waitSampling(20)
  }

  /** Sends bytes as far as `cts` lets the host; with `wait`, returns when all are sent. */
  def send(bytes: Seq[Int], wait: Boolean = false): Unit = bytes.grouped(ring.toInt / 2).foreach { part =>
    waitUntil(s"${part.length} bytes find no room in the host", queuedNow + part.length <= ring)
    for ((b, i) <- part.zipWithIndex) dut.host.memory.setBigInt((queued + i) % ring, BigInt(b))
    queued += part.length
    dut.io.queued #= queued % modulus
    if (wait) waitUntil("the host cannot send", queuedNow == 0)
  }

  /** Sends a frame and waits until `pixels` more have reached the display; gives the clocks from the first command bit
    * to the last display bit.
    */
  def frame(bytes: Seq[Int], pixels: Int): Long = {
    waitUntil("the host cannot send", queuedNow == 0)
    dut.io.frameStart #= queued % modulus
    dut.clockDomain.waitSampling(2)
    val due = controller.pixels + pixels
    send(bytes)
    waitUntil(s"a frame of $pixels pixels is not complete", controller.pixels >= due)
    dut.clockDomain.waitSampling(4)
    dut.io.lastBit.toLong - dut.io.firstBit.toLong
  }

  /** Lets clocks pass. */
  def run(clocks: Int): Unit = {
    sleep(EngineSim.Period * clocks)
    dut.clockDomain.waitSampling()
    reader.drain()
  }

  private def queuedNow: Long = (queued - dut.io.sent.toLong + modulus) % modulus

  private def waitUntil(what: String, done: => Boolean): Unit = {
    var (last, quiet) = (-1L, 0)
    while (!done) {
      run(StepClocks)
      val now = reader.bytes + dut.io.sent.toLong
      quiet = if (now == last) quiet + StepClocks else 0
      last = now
      if (quiet >= HangClocks) throw new IllegalStateException(
        s"the board hangs: $what, and no pin has moved for $quiet clocks; ${controller.pixels} pixels have reached " +
          s"the display, $queuedNow bytes wait, cts is ${dut.io.cts.toBoolean}"
      )
    }
  }
}

object PinsSession {

  /** Clocks between two looks of the JVM; a byte at the display takes 16. */
  val StepClocks = 20000

  /** A working board moves its pins far more often. */
  val HangClocks = 600000
}
