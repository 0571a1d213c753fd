package frustum.bus

import frustum.contract.raster.{Command, RasterConfig, StoreLayout}
import frustum.device.Tech
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.raster.link.LinkModel
import frustum.peripheral.SpiHost
import frustum.raster.link.{CommandLink, Framer, LinkChecks, LinkSink, LinkStatus, LinkTraffic}
import frustum.raster.store.{FrameJob, Store, StoreBus}
import frustum.raster.texture.TexelWrite
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.util.Random

/** From the pins to the store. */
case class SpiLinkTop(config: RasterConfig) extends Component {
  val io = new Bundle {
    val pins = slave(CommandPins())
    val cts = out Bool ()
    val rival = slave(StoreBus(StoreLayout(config)))
    val texels = master(Stream(TexelWrite()))
    val job = master(Stream(FrameJob(config)))
    val jobDone = in Bool ()
  }
  val spi = SpiSlave(LinkStatus.Magic, LinkStatus.Version)
  val link = CommandLink(config, dropWhenFull = true)
  val store = Store(StoreLayout(config), 2, Tech.Generic)
  store.io.clients(0) <> io.rival
  store.io.clients(1) <> link.io.store
  spi.io.pins <> io.pins
  spi.io.answer := link.io.status.select(spi.io.ask)
  spi.io.bytes >> link.io.bytes
  link.io.texels >> io.texels
  link.io.job >> io.job
  link.io.jobDone := io.jobDone
  link.io.undrawn := io.jobDone || RegNext(io.jobDone, False) // two of each job
  io.cts := link.io.status.cts
}

class SpiSlaveTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig(width = 80, height = 64, maxVertices = 50, maxTriangles = 40, textureTexels = 1024)
  private lazy val compiled = FrustumSim.compile("SpiLinkTop")(SpiLinkTop(config))

  // Times in ps: half periods of SCK at 48 MHz and 10 MHz, periods of core clocks at 36, 48 and 24 MHz.
  private val sck48 = 10417L
  private val sck10 = 50000L

  private def simulate(name: String, seed: Int, half: Long, core: Int, late: Int = 0)(
      body: (SpiLinkTop, SpiHost, LinkSink, LinkModel) => Unit
  ): Unit = compiled.doSim(name, seed) { dut =>
    val sink = new LinkSink(config, dut.clockDomain, dut.io.texels, dut.io.job, dut.io.jobDone, dut.io.rival, 0.3)
    val host = new SpiHost(dut.io.pins, half, () => dut.io.cts.toBoolean, late)
    host.idle()
    sink.start()
    SimTimeout(20L * 1000 * 1000 * 1000)
    dut.clockDomain.forkStimulus(period = core)
    dut.clockDomain.waitSampling(20)
    body(dut, host, sink, new LinkModel(config))
  }

  private def settle(dut: SpiLinkTop, sink: LinkSink, model: LinkModel): Unit = {
    for (_ <- 0 until 3000 if sink.done < model.jobs.length) dut.clockDomain.waitSampling(10)
    dut.clockDomain.waitSampling(6000)
  }

  private def statusAgrees(host: SpiHost, sink: LinkSink, model: LinkModel, where: String): Unit = {
    val twice = host.status() ++ host.status()
    for (status <- twice.grouped(LinkStatus.Bytes)) {
      val counters = model.counters(sink.done, undrawn = 2 * sink.done)
      val errors =
        Seq(counters.dropped, counters.verticesRefused, counters.trianglesRefused, counters.incomplete).exists(_ > 0)
      assert(SpiHost.counters(status) == counters, where)
      assert(status(1) == LinkStatus.Version, where)
      assert(status(2) == ((sink.done & 1) << 1 | 4 | 16 | (if (errors) 8 else 0)), where)
    }
    val long = host.send(Seq.fill(2 * LinkStatus.Bytes - 2)(Command.Flag), heedCts = false)
    assert(long.drop(LinkStatus.Bytes) == long.slice(2, LinkStatus.Bytes), where)
  }

  for (
    (half, core, late, seed) <-
      Seq((sck48, 27778, 0, 1), (sck48, 27778, Framer.BytesAfterRoom, 2), (sck48, 20833, 8, 3), (sck10, 41667, 4, 4))
  )
    test(s"SCK half period $half ps, core period $core ps, $late bytes after cts: nothing is lost") {
      simulate(s"heed$seed", seed, half, core, late) { (dut, host, sink, model) =>
        val t = new LinkTraffic(config, new Random(seed))
        for (n <- 0 to 8) {
          val bytes = if (n == 0) t.fill() else t.bytes(t.frame(n), errors = n % 2 == 0)
          host.send(bytes)
          model.feed(bytes)
        }
        settle(dut, sink, model)
        LinkChecks.same(config, model, sink, s"seed $seed")
        statusAgrees(host, sink, model, s"seed $seed")
      }
    }

  test("a host that ignores cts loses whole commands, each counted, and nothing hangs") {
    simulate("ignore", 5, sck48, 27778) { (dut, host, sink, model) =>
      val texels = Command.encode(Command.Texels, 0 +: (0 until 100))
      val begin = Command.encode(Command.Begin, Seq(1, 2, 0, 0))
      val draw = Command.encode(Command.Draw, Seq(0, 0))
      val burst = (begin ++ draw ++ begin ++ draw ++ begin ++ draw) ++ Seq.fill(20)(texels).flatten
      sink.paused = true
      host.send(burst, heedCts = false)
      sink.paused = false
      for (_ <- 0 until 3000 if sink.done < 3) dut.clockDomain.waitSampling(10)
      dut.clockDomain.waitSampling(6000)
      val counters = SpiHost.counters(host.status())
      assert(counters.accepted + counters.dropped == 26 && counters.dropped > 0, counters.toString)
      assert(sink.texels.take(100).sameElements(0 until 100))
      host.send(begin ++ draw)
      dut.clockDomain.waitSampling(6000)
      assert(SpiHost.counters(host.status()) == counters.copy(
        accepted = counters.accepted + 2,
        drawn = 4,
        trianglesUndrawn = 8
      ))
    }
  }

  test("a host may stop after any bit and start again") {
    simulate("stop", 6, sck48, 27778) { (dut, host, sink, model) =>
      val t = new LinkTraffic(config, new Random(6))
      for (n <- 0 to 24) {
        val bytes = if (n == 0) t.fill() else t.bytes(t.frame(n), errors = false)
        val cut = bytes.take(n * 5)
        host.send(cut)
        host.sendBits(0xa5, n % 8) // the rest of the byte never comes
        host.send(bytes)
        model.feed(cut ++ bytes)
      }
      settle(dut, sink, model)
      LinkChecks.same(config, model, sink, "seed 6")
      statusAgrees(host, sink, model, "seed 6")
    }
  }
}
