package frustum.peripheral

import frustum.bus.SpiSlave
import frustum.contract.raster.{RasterConfig, StoreLayout}
import frustum.device.Tech
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.raster.link.LinkModel
import frustum.raster.link.{CommandLink, LinkChecks, LinkSink, LinkStatus, LinkTraffic}
import frustum.raster.store.{FrameJob, Store, StoreBus}
import frustum.raster.texture.TexelWrite
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.util.Random

/** The simulated host at the link's pins. */
case class SimSpiHostTop(config: RasterConfig, halfPeriod: Int) extends Component {
  val io = new Bundle {
    val rival = slave(StoreBus(StoreLayout(config)))
    val texels = master(Stream(TexelWrite()))
    val job = master(Stream(FrameJob(config)))
    val jobDone = in Bool ()
    val bytes = in UInt (15 bits)
    val sent = out UInt (15 bits)
    val status = out(LinkStatus())
  }
  val host = SimSpiHost(bytesLog2 = 14, halfPeriod)
  val spi = SpiSlave(LinkStatus.Magic, LinkStatus.Version)
  val link = CommandLink(config, dropWhenFull = true)
  val store = Store(StoreLayout(config), 2, Tech.Generic)
  store.io.clients(0) <> io.rival
  store.io.clients(1) <> link.io.store
  spi.io.pins <> host.io.pins
  spi.io.answer := link.io.status.select(spi.io.ask)
  spi.io.bytes >> link.io.bytes
  host.io.cts := link.io.status.cts
  host.io.bytes := io.bytes
  io.sent := host.io.sent
  link.io.texels >> io.texels
  link.io.job >> io.job
  link.io.jobDone := io.jobDone
  link.io.undrawn := False
  io.status := link.io.status
}

class SimSpiHostTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig(width = 80, height = 64, maxVertices = 50, maxTriangles = 40, textureTexels = 1024)

  for (half <- Seq(1, 3)) test(s"what it sends arrives, half period $half clocks") {
    val seed = 10 + half
    FrustumSim.compile(s"SimSpiHost_$half")(SimSpiHostTop(config, half)).doSim(s"seed$seed", seed) { dut =>
      val t = new LinkTraffic(config, new Random(seed))
      val bytes = t.fill() ++ (1 to 8).flatMap(n => t.bytes(t.frame(n), errors = true))
      val model = new LinkModel(config)
      model.feed(bytes)
      val sink = new LinkSink(config, dut.clockDomain, dut.io.texels, dut.io.job, dut.io.jobDone, dut.io.rival, 0.3)
      sink.start()
      dut.io.bytes #= 0
      SimTimeout(10L * 2000000)
      dut.clockDomain.forkStimulus(period = 10)
      dut.clockDomain.waitSampling(20)
      SimSpiHost.load(dut.host.memory, bytes)
      dut.io.bytes #= bytes.length
      while (dut.io.sent.toInt < bytes.length || sink.done < model.jobs.length) dut.clockDomain.waitSampling(100)
      dut.clockDomain.waitSampling(6000)
      LinkChecks.same(config, model, sink, s"seed $seed")
      assert(LinkChecks.counters(dut.io.status) == model.counters(sink.done), s"seed $seed")
    }
  }
}
