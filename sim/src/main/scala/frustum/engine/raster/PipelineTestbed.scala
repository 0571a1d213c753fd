package frustum.engine.raster

import frustum.contract.raster.RasterConfig
import frustum.device.Tech
import frustum.peripheral.{SimByteFeeder, SimEventRecorder, SimPixelRecorder, SimRandomStall}
import frustum.raster.link.LinkStatus
import frustum.raster.RasterPipeline
import spinal.core._
import spinal.core.sim._

/** The Stream core with simulated hardware on both sides that feeds it and takes its pixels, so that the JVM need not
  * be woken while it runs.
  */
case class PipelineTestbed(config: RasterConfig) extends Component {
  val io = new Bundle {
    val queued = in UInt (32 bits) // see SimByteFeeder
    val byteStall, pixelStall = in UInt (8 bits) // see SimRandomStall
    val seed = in UInt (32 bits)
    val status = out(LinkStatus())
  }
  val pipeline = RasterPipeline(config, tech = Tech.Generic)
  val feeder = SimByteFeeder()
  val recorder = SimPixelRecorder(config)
  val events = SimEventRecorder(PipelineEvent.Count)
  val time = RegInit(U(0, 36 bits))
  time := time + 1

  val byteStalls = new SimRandomStall(io.byteStall, io.seed)
  val pixelStalls = new SimRandomStall(io.pixelStall, ~io.seed)
  feeder.io.queued := io.queued
  feeder.io.stall := byteStalls.stall
  recorder.io.stall := pixelStalls.stall
  recorder.io.time := time
  events.io.time := time
  feeder.io.bytes >> pipeline.io.bytes
  pipeline.io.pixels >> recorder.io.pixels
  io.status := pipeline.io.status

  events.io.pulses(PipelineEvent.Start) := pipeline.io.drawing.rise(False)
  events.io.pulses(PipelineEvent.Drawn) := pipeline.io.drawing.fall(False)
  events.io.pulses(PipelineEvent.SetUp) := pipeline.io.setUp
  events.io.pulses(PipelineEvent.Moved) := pipeline.io.moved
  events.io.pulses(PipelineEvent.Undrawn) := pipeline.io.undrawn
  private val job = pipeline.rasterizer.setup.found // given back when it has been dealt with
  private val jobDone = job.valid.pull() && job.ready.pull()
  private val tileEnd = job.job.tileEnd.pull()
  events.io.pulses(PipelineEvent.Missed) := jobDone && !tileEnd && !pipeline.io.moved
  events.io.pulses(PipelineEvent.TileEnd) := jobDone && tileEnd
}

/** What happens in a pipeline, as [[SimEventRecorder]] keeps it; `time` in clocks since reset. */
final case class PipelineEvent(kind: Int, time: Long)

object PipelineEvent {

  /** A frame or pass starts, its store loaded; its last triangle is drawn; a triangle was set up whole; was moved to a
    * tile; has no pixel in a tile that its box touches; no more triangles in a tile; a triangle faces away or has no
    * area.
    */
  val Start = 0
  val Drawn = 1
  val SetUp = 2
  val Moved = 3
  val Missed = 4
  val TileEnd = 5
  val Undrawn = 6
  val Names = Seq("started", "drawn", "set up", "moved", "missed", "tile ends", "undrawn")
  val Count: Int = Names.length
}
