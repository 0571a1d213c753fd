package frustum.raster.link

import frustum.contract.raster.{
  Combine,
  Command,
  FixedState,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RenderState,
  StoreLayout,
  TexelFormat,
  TextureRef,
  VertexRanges
}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.raster.link.{CommandDecoder => DecoderModel, Job, LinkCounters, LinkModel}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class CommandLinkTest extends AnyFunSuite with Simulated {
  private val small = RasterConfig(width = 80, height = 64, maxVertices = 50, maxTriangles = 40, textureTexels = 1024)
  private lazy val compiled = FrustumSim.compile("CommandLink_small")(CommandLinkTop(small))

  private def run(
      sim: SimCompiled[CommandLinkTop],
      config: RasterConfig,
      stream: Seq[Int],
      seed: Int,
      stall: Double
  ): Unit = {
    val model = new LinkModel(config)
    model.feed(stream)
    sim.doSim(s"seed${seed}_stall$stall", seed) { dut =>
      val clock = dut.clockDomain
      val sink = new LinkSink(config, clock, dut.io.texels, dut.io.job, dut.io.jobDone, dut.io.rival, stall)
      dut.io.bytes.valid #= false
      sink.start()
      SimTimeout(10L * (stream.length * 60 + 400000 + model.jobs.length * 20000))
      clock.forkStimulus(period = 10)
      clock.waitSampling(4)
      for (byte <- stream) {
        while (simRandom.nextDouble() < stall) clock.waitSampling()
        dut.io.bytes.valid #= true
        dut.io.bytes.payload #= byte
        clock.waitSamplingWhere(dut.io.bytes.ready.toBoolean)
        dut.io.bytes.valid #= false
      }
      while (sink.done < model.jobs.length) clock.waitSampling(10)
      clock.waitSampling(6000)
      LinkChecks.same(config, model, sink, s"seed $seed, stall $stall")
      assert(LinkChecks.counters(dut.io.status) == model.counters(sink.done), s"seed $seed, stall $stall")
    }
  }

  private def traffic(config: RasterConfig, seed: Int, frames: Int): Seq[Int] = {
    val t = new LinkTraffic(config, new Random(seed))
    t.fill() ++ (1 to frames).flatMap(n => t.bytes(t.frame(n), errors = true)) ++ t.bytes(t.frame(99), errors = false)
  }

  for ((stall, seed) <- Seq((0.0, 1), (0.4, 2), (0.7, 3)))
    test(s"hardware and model agree on random traffic, stall $stall") {
      run(compiled, small, traffic(small, seed, 40), seed, stall)
    }

  test("and for the default sizes") {
    val config = RasterConfig()
    val sim = FrustumSim.compile("CommandLink_default")(CommandLinkTop(config))
    run(sim, config, traffic(config, 4, 6), 4, 0.1)
  }

  test("and for hardware that cannot blend, clamp or write other than RGB565: states that ask for it are refused") {
    val config = small.copy(fixed =
      FixedState.fields(
        "blend" -> 0,
        "texelFormat" -> 0
      ).bits("wrapS", mask = 1, value = 0).bits("wrapT", mask = 1, value = 0)
    )
    val sim = FrustumSim.compile("CommandLink_fixed")(CommandLinkTop(config))
    run(sim, config, traffic(config, 5, 20), 5, 0.2)
  }

  test("and for hardware made for one scene: what goes beyond its ranges, state and clear colour is refused") {
    val config = small.copy(
      maxVertices = 32,
      maxTriangles = 16,
      fixed = FixedState.of(RenderState(Some(TextureRef(0, 5, 5, TexelFormat.Rgb565)), combine = Combine.Replace)),
      ranges = VertexRanges(position = 8, repeats = 1, ratio = 1),
      clearColor = Some(0x7e21)
    )
    val sim = FrustumSim.compile("CommandLink_scene")(CommandLinkTop(config))
    for ((stall, seed) <- Seq((0.0, 6), (0.3, 7))) run(sim, config, traffic(config, seed, 30), seed, stall)
  }

  test(
    "a triangle that names a state not sent in this frame is refused and counted, whatever was sent in frames before"
  ) {
    val t = new LinkTraffic(small, new Random(9))
    val triangle = PackedTriangle(0, 0, 1, 2).words
    def corner(x: Int, y: Int) = PackedVertex(x, y, 0, 32768, 16, 0, 0, 0, 0, 0, 255).words
    val vertices = (Command.Vertices, 0 +: Seq((0, 0), (640, 0), (0, 640)).flatMap((corner _).tupled))
    def state(index: Int) = (Command.State, Seq(index, 0, 0))
    def frame(number: Int, sent: Seq[Int], named: Int) =
      Seq((Command.Begin, Seq(number, 0, 0x0001, 0x0001))) ++ sent.map(state) ++ Seq(
        vertices,
        (Command.Triangles, Seq(named) ++ triangle ++ triangle),
        (Command.Draw, Seq(3, 2))
      )
    // Each state alone, then named without it, then all others, and all; both banks hold all by then.
    val frames = (0 until RenderState.Count).flatMap(n =>
      Seq(Seq(n) -> n, Nil -> n, (0 until RenderState.Count).filter(_ != n) -> n, (0 until RenderState.Count) -> n)
    )
    val stream = t.fill() ++ frames.zipWithIndex.flatMap { case ((sent, named), i) =>
      t.bytes(frame(i, sent, named), errors = false)
    }
    val model = new LinkModel(small)
    model.feed(stream)
    val refused = frames.count { case (sent, named) => !sent.contains(named) }
    assert(model.jobs.drop(2).map(_.triangleCount) == frames.map { case (sent, named) =>
      if (sent.contains(named)) 2 else 0
    })
    assert(model.counters(0).trianglesRefused == 2 * refused)
    for ((stall, seed) <- Seq((0.0, 9), (0.5, 10))) run(compiled, small, stream, seed, stall)
  }

  test("without being told otherwise a link has its source wait: nothing is lost while no job gets done") {
    val begin = Command.encode(Command.Begin, Seq(1, 2, 0, 0))
    val draw = Command.encode(Command.Draw, Seq(0, 0))
    val texels = Command.encode(Command.Texels, 0 +: (0 until 100))
    val stream = (begin ++ draw) ++ (begin ++ draw) ++ Seq.fill(20)(texels).flatten
    compiled.doSim("waits", 11) { dut =>
      val sink = new LinkSink(small, dut.clockDomain, dut.io.texels, dut.io.job, dut.io.jobDone, dut.io.rival, 0)
      dut.io.bytes.valid #= false
      sink.start()
      sink.paused = true
      SimTimeout(10L * 400000)
      dut.clockDomain.forkStimulus(period = 10)
      var taken = 0
      fork {
        for (byte <- stream) {
          dut.io.bytes.valid #= true
          dut.io.bytes.payload #= byte
          dut.clockDomain.waitSamplingWhere(dut.io.bytes.ready.toBoolean)
          taken += 1
        }
        dut.io.bytes.valid #= false
      }
      dut.clockDomain.waitSampling(20000)
      assert(taken < stream.length && !dut.io.bytes.ready.toBoolean, s"$taken of ${stream.length} bytes were taken")
      sink.paused = false
      while (sink.done < 2 || taken < stream.length) dut.clockDomain.waitSampling(10)
      dut.clockDomain.waitSampling(6000)
      assert(LinkChecks.counters(dut.io.status) == LinkCounters(24, 0, 0, 0, 0, 2, 0))
      assert(sink.texels.take(100).sameElements(0 until 100))
    }
  }

  test("a byte flipped, lost or added anywhere costs one command at most and is counted") {
    val t = new LinkTraffic(small, new Random(5))
    val commands = Seq(
      (Command.Begin, Seq(7, 0x1234, 0x0001, 0x0002)),
      (Command.State, Seq(3, 0x7e7d, 0x7d7e)),
      (Command.Vertices, 0 +: Seq.fill(2)(t.vertex()).flatten),
      (Command.Texels, Seq(5, 0x7e00, 0x1111)),
      (Command.Draw, Seq(2, 0))
    )
    val clean = t.bytes(commands, errors = false)
    val after = t.bytes(Seq((Command.Begin, Seq(8, 0, 0, 0)), (Command.Draw, Seq(0, 0))), errors = false)
    val spoilt = for (at <- clean.indices; kind <- 0 until 4) yield kind match {
      case 0 => clean.patch(at, Seq(clean(at) ^ (1 << at % 8)), 1)
      case 1 => clean.patch(at, Nil, 1)
      case 2 => clean.patch(at, Seq(Seq(0x7e, 0x7d, 0, 0x55)(at % 4)), 0)
      case 3 => clean.take(at)
    }
    for (stream <- spoilt) {
      val framer = new frustum.model.raster.link.Framer
      val got = (stream ++ after).flatMap(framer.take)
      val lost = commands.map { case (c, p) => (c.opcode, p) }.diff(got).length
      val cut = clean.startsWith(stream) // the host stopped: what it did not send is not lost on the way
      assert(cut || lost <= 1, s"${stream.mkString(" ")} lost $lost commands")
      assert(lost == 0 || cut || framer.dropped >= 1, s"${stream.mkString(" ")}: nothing counted")
      assert(got.takeRight(2) == Seq((Command.Begin.opcode, Seq(8, 0, 0, 0)), (Command.Draw.opcode, Seq(0, 0))))
    }
    run(compiled, small, spoilt.flatMap(_ ++ after), 5, 0.0)
  }
}

/** Comparisons of what the hardware left behind with the model. */
object LinkChecks {
  def counters(s: LinkStatus): LinkCounters = LinkCounters(
    s.accepted.toInt,
    s.dropped.toInt,
    s.verticesRefused.toInt,
    s.trianglesRefused.toInt,
    s.incomplete.toInt,
    s.drawn.toInt,
    s.trianglesUndrawn.toInt
  )

  def same(config: RasterConfig, model: LinkModel, sink: LinkSink, where: String): Unit = {
    val layout = StoreLayout(config)
    assert(sink.jobs.length == model.jobs.length, s"$where: jobs")
    for (((got, should), i) <- sink.jobs.zip(model.jobs).zipWithIndex) {
      def head(j: Job) = j.copy(store = IndexedSeq.empty)
      assert(head(got) == head(should), s"$where: job $i")
      for (a <- should.store.indices if should.store(a) != DecoderModel.Unwritten)
        assert(
          (got.store(a) & mask(layout, a)) == should.store(a),
          s"$where: job $i, word $a is ${got.store(a).toHexString}, should be ${should.store(a).toHexString}"
        )
    }
    assert(sink.texels.sameElements(model.decoder.texels), s"$where: texels")
  }

  /** Bits of a store word that mean something. */
  private def mask(layout: StoreLayout, address: Int): Long =
    0xffffffffL & layout.mask(address)
}
