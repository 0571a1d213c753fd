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
  TriangleLayout,
  VertexLayout,
  VertexRanges
}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.raster.link.{CommandDecoder => DecoderModel, Job, LinkCounters, LinkModel}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.sim.StreamDriver

import scala.util.Random

class CommandLinkTest extends AnyFunSuite with Simulated {
  private val small = RasterConfig(width = 80, height = 64, maxVertices = 50, maxTriangles = 40, textureTexels = 1024)
  private lazy val compiled = FrustumSim.compile("CommandLink_small")(CommandLinkTop(small))

  private val usual = RasterConfig()
  private lazy val compiledUsual = FrustumSim.compile("CommandLink_default")(CommandLinkTop(usual))

  private def run(
      sim: SimCompiled[CommandLinkTop],
      config: RasterConfig,
      stream: Seq[Int],
      seed: Int,
      stall: Double,
      done: LinkSink => Unit = _ => ()
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
      done(sink)
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
    run(compiledUsual, usual, traffic(usual, 4, 6), 4, 0.1)
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
        dut.clockDomain.waitSampling(4)
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

  /** Cycles from the first byte of a frame of these commands until its job, with no stall but the link's own. */
  private def cycles(commands: Seq[(Command, Seq[Int])]): Int = {
    val traffic = new LinkTraffic(usual, new Random(1))
    val vertices = commands.filter(_._1 == Command.Vertices).map(c => (c._2.length - 1) / VertexLayout.words).sum
    val triangles = commands.filter(_._1 == Command.Triangles).map(c => (c._2.length - 1) / TriangleLayout.words).sum
    val whole = Seq(0, 0, usual.tilesX - 1, usual.tilesY - 1)
    val begin = Seq(Command.Begin -> Seq(1, 0, whole(2), whole(3)), Command.State -> (0 +: RenderState().words))
    val frame = begin ++ commands :+ (Command.Draw -> Seq(vertices, triangles))
    var count = 0
    compiledUsual.doSim("cycles", 1) { dut =>
      dut.io.rival.cmd.valid #= false
      dut.io.rival.cmd.write #= false
      dut.io.texels.ready #= true
      dut.io.job.ready #= false
      dut.io.jobDone #= false
      val bytes = collection.mutable.Queue(traffic.bytes(frame, errors = false): _*)
      StreamDriver(dut.io.bytes, dut.clockDomain) { byte =>
        bytes.nonEmpty && { byte #= bytes.dequeue(); true }
      }.transactionDelay = () => 0
      SimTimeout(10L * 200000)
      dut.clockDomain.forkStimulus(period = 10)
      dut.clockDomain.waitSamplingWhere { count += 1; dut.io.job.valid.toBoolean }
      assert(dut.io.job.triangleCount.toInt == triangles && dut.io.status.accepted.toInt == commands.length + 2)
    }
    count
  }

  test("a vertex takes 31 cycles and a triangle 55, as docs/architecture.md has it, a texel some 2") {
    val corners = Seq((0, 0), (800, 0), (0, 800)).map { case (x, y) =>
      PackedVertex(x, y, 0, 32768, 16, 0, 0, 0, 0, 0, 0).words
    }
    def vertices(count: Int) = Command.Vertices -> (0 +: Seq.tabulate(count)(n => corners(n % 3)).flatten)
    val triangles = Command.Triangles -> (0 +: Seq.fill(59)(PackedTriangle(0, 0, 1, 2).words).flatten)
    // Full commands in a row, so that the next one is received while one is executed.
    def perCommand(command: (Command, Seq[Int])) =
      (cycles(vertices(3) +: Seq.fill(10)(command)) - cycles(vertices(3) +: Seq.fill(2)(command))) / 8.0
    val (vertex, triangle) = (perCommand(vertices(11)) / 11, perCommand(triangles) / 59)
    val texel = perCommand(Command.Texels -> (0 +: Seq.fill(119)(0x1234))) / 119
    info(f"$vertex%.1f cycles per vertex, $triangle%.1f per triangle, $texel%.2f per texel")
    assert((vertex - 31).abs < 1 && (triangle - 55).abs < 1)
    assert(texel >= 2 && texel < 2.3)
  }

  // The tables of the contract are in model and hardware alike; these words are docs/commands.md's, by hand.
  test("a frame written by hand leaves the words in the store that are written by hand") {
    def command(opcode: Int, words: Int*) = Command.encode(Command(opcode, "by hand", Nil, ""), words)
    val frame = Seq(
      // Frame 0x55, clear colour, tile columns 0 to 4, rows 0 to 3.
      command(0x01, 0x0055, 0x1234, 0x0004, 0x0003),
      // State 11. RGBA4444 1 << 15, height 64 = 2^(3 + 3), width 32 = 2^(2 + 3), base 5; then alpha reference 9 << 11,
      // blend 1 << 10, depth write 1 << 9, less or equal 3 << 6, modulate 2 << 4, mirror 2 << 2, clamp 1.
      command(0x02, 0x000b, 0xb405, 0x4ee9),
      // Index; x, y, z, qMantissa; qExponent << 11 and s over two words, t over two words; r g, b a.
      command(0x03, 0x0005, 0x0010, 0x0020, 0x1234, 0x8000, 0x8000, 0x0000, 0x0000, 0x0000, 0x1122, 0x3344),
      // s = 0xa000, t = -0x8000
      command(0x03, 0x0012, 0x0390, 0x0030, 0x2345, 0x9000, 0x7800, 0xa000, 0x07ff, 0x8000, 0x5566, 0x7788),
      // s = -0x14000, t = 0x18000
      command(0x03, 0x002a, 0x0100, 0x0240, 0x4567, 0xa000, 0x87fe, 0xc000, 0x0001, 0x8000, 0x99aa, 0xbbcc),
      // State 11; v0 = 5 in bits 13..4, v1 = 0x12 in bits 15..10 of the second word, v2 = 0x2a.
      command(0x04, 0x000b, 0x0050, 0x482a),
      // 3 vertices and 1 triangle: the example of docs/commands.md.
      Seq(0x7e, 0x06, 0x02, 0x00, 0x03, 0x00, 0x01, 0x8e, 0x03)
    )
    // With 50 vertices and 40 triangles, word k of vertex i is at 0x40 k + i, state i at 0x140 + i, triangles from
    // 0x180. A vertex keeps the words of the wire in pairs. Bits 24..0 are s and t; the frame's number is above t.
    val (all, coordinate) = (0xffffffffL, 0xf9ffffffL)
    val vertices = Seq(
      0x05 -> Seq(0x00100020L, 0x12348000L, 0x80000000L, 0xaa000000L, 0x11223344L),
      0x12 -> Seq(0x03900030L, 0x23459000L, 0x7800a000L, 0xabff8000L, 0x55667788L),
      0x2a -> Seq(0x01000240L, 0x4567a000L, 0x81fec000L, 0xaa018000L, 0x99aabbccL)
    )
    val words = vertices.flatMap { case (index, words) =>
      words.zip(Seq(all, all, coordinate, all, all)).zipWithIndex.map { case ((word, mask), k) =>
        (0x40 * k + index, mask, word)
      }
    } ++ Seq(
      (0x14b, all, 0xb4054ee9L),
      (0x180, 0x3fffffffL, 0x0050482aL),
      // State 11 << 28; tiles of 16 x 16 pixels: columns 0 to 3 (<< 10), as x is 1 to 57 pixels; rows 0 to 2, y is 2 to
      // 36.
      (0x181, 0xf00fffffL, 0xb0000c02L)
    )
    run(
      compiled,
      small,
      frame.flatten,
      6,
      0.0,
      sink => {
        val job = sink.jobs.head
        assert(sink.jobs.length == 1 && job.triangleCount == 1 && job.clearColor == 0x1234)
        for ((address, mask, word) <- words)
          assert(
            (job.store(address) & mask) == word,
            s"store word ${address.toHexString}: ${job.store(address).toHexString}"
          )
      }
    )
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
