package frustum.engine.raster

import frustum.contract.raster.{FramePass, RasterConfig, TileRegion}
import frustum.engine.EngineSim
import frustum.peripheral.{RecordedPixel, SimEventRecorder, SimPixelRecorder}
import spinal.core.sim._
import scala.collection.mutable

/** A pass as it was drawn.
  *
  * @param clocks from the start of its job, the store loaded, to its last pixel
  * @param events of this pass
  */
final case class DrawnPass(clocks: Long, events: Seq[PipelineEvent]) {
  def setUps: Int = events.count(_.kind == PipelineEvent.SetUp)
  def moves: Int = events.count(_.kind == PipelineEvent.Moved)
  def undrawn: Int = events.count(_.kind == PipelineEvent.Undrawn)
}

/** Talks to a running [[PipelineTestbed]]: bytes in, passes out. To be made first thing in the simulation.
  *
  * @param byteStall,pixelStall probability, in each clock, that no byte is offered or no pixel taken
  */
final class PipelineSession(dut: PipelineTestbed, seed: Long = 1, byteStall: Double = 0, pixelStall: Double = 0) {
  import PipelineSession._
  private val config = dut.config
  private val waiting = mutable.Queue.empty[Int] // bytes for which the ring had no room yet
  private val pixels = mutable.Queue.empty[RecordedPixel]
  private val events = mutable.Queue.empty[PipelineEvent]
  private var (queued, takenPixels, takenEvents) = (0L, 0L, 0L)

  dut.io.queued #= 0
  dut.io.byteStall #= (byteStall * 256).toInt.min(255)
  dut.io.pixelStall #= (pixelStall * 256).toInt.min(255)
  dut.io.seed #= (seed & 0x7fffffff) | 1
  dut.clockDomain.forkStimulus(EngineSim.Period)
  dut.clockDomain.waitSampling(2)

  /** Queues bytes; they go on their way while the simulation runs. */
  def send(bytes: Seq[Int]): Unit = waiting ++= bytes

  /** Lets clocks pass; gives what has been seen of progress. */
  def run(clocks: Int): Long = {
    val room = (1L << dut.feeder.bytesLog2) - (queued - dut.feeder.io.sent.toLong)
    for (_ <- 0L until room.min(waiting.length)) {
      dut.feeder.memory.setBigInt(queued & ((1L << dut.feeder.bytesLog2) - 1), BigInt(waiting.dequeue()))
      queued += 1
    }
    dut.io.queued #= queued
    sleep(EngineSim.Period * clocks)
    dut.clockDomain.waitSampling()
    takePixels()
    takeEvents()
    dut.feeder.io.sent.toLong + takenPixels + takenEvents
  }

  /** The next pass that comes out; its pixels are put into `into`, rows from the top. A pipeline that does nothing for
    * [[HangClocks]] is an error, as is a pixel that does not belong to the region.
    */
  def take(region: TileRegion, into: Array[Int]): DrawnPass = {
    val total = pixelsOf(region, config)
    var last = -1L
    var quiet = 0
    while (pixels.length < total || !events.exists(_.kind == PipelineEvent.Drawn)) {
      val now = run(StepClocks)
      quiet = if (now == last) quiet + StepClocks else 0
      last = now
      if (quiet >= HangClocks) throw new IllegalStateException(
        s"the pipeline hangs: nothing for $quiet clocks, ${pixels.length} of $total pixels of a pass have come, " +
          s"${waiting.length + queued - dut.feeder.io.sent.toLong} bytes were not taken, " +
          s"events since the last pass: ${PipelineEvent.Names.indices.map(k =>
              s"${events.count(_.kind == k)} ${PipelineEvent.Names(k)}"
            ).mkString(", ")}; $status"
      )
    }
    val taken = Seq.fill(total)(pixels.dequeue())
    new TileAssembler(config, region, into).put(taken)
    val mine = mutable.ArrayBuffer.empty[PipelineEvent]
    while (!mine.lastOption.exists(_.kind == PipelineEvent.Drawn)) mine += events.dequeue()
    val start = mine.find(_.kind == PipelineEvent.Start).get
    DrawnPass(taken.last.time - start.time + 1, mine.toSeq)
  }

  def take(pass: FramePass, into: Array[Int]): DrawnPass = take(pass.region, into)

  /** Resets the hardware and forgets what was on its way. */
  def reset(): Unit = {
    dut.clockDomain.assertReset()
    waiting.clear()
    queued = 0
    dut.io.queued #= 0
    sleep(EngineSim.Period * 10)
    dut.clockDomain.deassertReset()
    pixels.clear()
    events.clear()
    takenPixels = 0
    takenEvents = 0
  }

  /** Forgets pixels and events of passes that were not taken. */
  def discard(): Unit = { pixels.clear(); events.clear() }

  /** Counters of the link, in one line. */
  def status: String = {
    val s = dut.io.status
    s"accepted ${s.accepted.toInt}, dropped ${s.dropped.toInt}, vertices refused ${s.verticesRefused.toInt}, " +
      s"triangles refused ${s.trianglesRefused.toInt}, incomplete ${s.incomplete.toInt}, drawn ${s.drawn.toInt}, " +
      s"triangles undrawn $undrawn"
  }

  /** The link's counter of triangles that face away or have no area. */
  def undrawn: Int = dut.io.status.trianglesUndrawn.toInt

  /** Whether the link has found fault with anything since reset. */
  def faulty: Boolean = dut.io.status.error.toBoolean

  private def takePixels(): Unit = {
    val count = dut.recorder.io.count.toLong
    require(count - takenPixels <= (1L << dut.recorder.entriesLog2), "pixels were not fetched in time")
    while (takenPixels < count) { pixels += SimPixelRecorder.entry(dut.recorder, takenPixels); takenPixels += 1 }
  }

  private def takeEvents(): Unit = {
    val count = dut.events.io.count.toLong
    require(count - takenEvents <= (1L << dut.events.entriesLog2), "events were not fetched in time")
    while (takenEvents < count) {
      val (kind, time) = SimEventRecorder.entry(dut.events, takenEvents)
      events += PipelineEvent(kind, time)
      takenEvents += 1
    }
  }
}

object PipelineSession {

  /** Clocks between two looks of the JVM; the rings hold more. */
  val StepClocks = 10000

  /** A working pipeline does something far more often. */
  val HangClocks = 200000

  def pixelsOf(region: TileRegion, c: RasterConfig): Int = {
    val width = ((region.x1 + 1) * c.tileWidth).min(c.width) - region.x0 * c.tileWidth
    val height = ((region.y1 + 1) * c.tileHeight).min(c.height) - region.y0 * c.tileHeight
    width * height
  }
}
