package frustum.raster.link

import frustum.contract.raster.{RasterConfig, StoreLayout, TileRegion}
import frustum.device.Tech
import frustum.model.raster.link.Job
import frustum.raster.store.{FrameJob, Store, StoreBus}
import frustum.raster.texture.TexelWrite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

/** The link with its store; `rival` comes before it at the store's port, to disturb it and to look inside. */
case class CommandLinkTop(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val bytes = slave(Stream(Bits(8 bits)))
    val rival = slave(StoreBus(layout))
    val texels = master(Stream(TexelWrite()))
    val job = master(Stream(FrameJob(config)))
    val jobDone = in Bool ()
    val status = out(LinkStatus())
  }
  val link = CommandLink(config)
  val store = Store(layout, 2, Tech.Generic)
  store.io.clients(0) <> io.rival
  store.io.clients(1) <> link.io.store
  link.io.bytes << io.bytes
  link.io.texels >> io.texels
  link.io.job >> io.job
  link.io.jobDone := io.jobDone
  link.io.undrawn := False
  io.status := link.io.status
}

/** Plays the rasterizer: takes texels and jobs, reads each job's bank, reports it done after a random time. */
final class LinkSink(
    config: RasterConfig,
    clock: ClockDomain,
    texelWrites: Stream[TexelWrite],
    job: Stream[FrameJob],
    jobDone: Bool,
    rival: StoreBus,
    stall: Double
) {
  import scala.collection.mutable.ArrayBuffer

  val layout = StoreLayout(config)
  val texels = Array.fill(config.textureTexels)(0)
  val jobs = ArrayBuffer.empty[Job]
  var done = 0

  /** While true no job gets done. */
  var paused = false

  /** Called before reset is released. */
  def start(): Unit = {
    jobDone #= false
    job.ready #= false
    rival.cmd.valid #= false
    rival.cmd.write #= false
    texelWrites.ready #= stall == 0
    clock.onSamplings {
      if (texelWrites.valid.toBoolean && texelWrites.ready.toBoolean)
        texels(texelWrites.address.toInt) = texelWrites.data.toInt
      texelWrites.ready #= simRandom.nextDouble() >= stall
    }
    fork {
      while (true) {
        disturb(simRandom.nextInt(40))
        job.ready #= true
        clock.waitSamplingWhere { rival.cmd.valid #= simRandom.nextDouble() < stall; job.valid.toBoolean }
        job.ready #= false
        val (bank, count, color) = (job.bank.toInt, job.triangleCount.toInt, job.clearColor.toInt)
        val region = TileRegion(job.x0.toInt, job.y0.toInt, job.x1.toInt, job.y1.toInt)
        jobs += Job(bank, count, color, region, readBank(bank))
        disturb(simRandom.nextInt(400))
        while (paused) clock.waitSampling()
        jobDone #= true
        clock.waitSampling()
        jobDone #= false
        done += 1
      }
    }
  }

  private def disturb(clocks: Int): Unit =
    for (_ <- 0 until clocks) { rival.cmd.valid #= simRandom.nextDouble() < stall; clock.waitSampling() }

  private def readBank(bank: Int): IndexedSeq[Long] = {
    val words = ArrayBuffer.empty[Long]
    rival.cmd.valid #= true
    var asked = 0
    rival.cmd.address #= bank << layout.bankAddressBits
    while (words.size < layout.bankWords) {
      clock.waitSampling()
      if (asked > 0 && rival.rsp.valid.toBoolean) words += rival.rsp.payload.toLong
      if (asked < layout.bankWords && rival.cmd.ready.toBoolean) {
        asked += 1
        rival.cmd.valid #= asked < layout.bankWords
        rival.cmd.address #= (bank << layout.bankAddressBits) | asked.min(layout.bankWords - 1)
      }
    }
    words.toIndexedSeq
  }
}
