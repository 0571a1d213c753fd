package frustum.raster

import frustum.contract.raster.{
  Combine,
  DepthFunction,
  FramePass,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RenderState,
  RenderStateLayout,
  StoreLayout,
  StoredState,
  StoredTriangle,
  StoredVertex,
  TexelFormat,
  TextureRef,
  TileRegion,
  Wrap
}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model
import frustum.raster.scan.InterpolatedFragment
import frustum.raster.store.{FrameJob, RenderStateWord, StoreBus}
import frustum.raster.tile.TilePosition
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._
import spinal.lib.sim._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

/** A rasterizer with a store of its own whose three clients never wait for one another, or now and then for nothing.
  *
  * @param latency clocks from a read to its answer
  */
case class RasterizerBench(config: RasterConfig, latency: Int) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val frame = slave(Stream(FrameJob(config)))
    val tile = master(Stream(TilePosition()))
    val state = out(RenderStateWord())
    val down = master(Stream(InterpolatedFragment(config)))
    val stall = in Bits (3 bits)
    val setUp, moved, undrawn = out Bool ()
  }
  val unit = Rasterizer(config)
  val store = Mem(Bits(32 bits), 1 << layout.addressBits).simPublic()
  io.frame >> unit.io.frame
  unit.io.tile >> io.tile
  unit.io.down >> io.down
  io.state := unit.io.state
  io.setUp := unit.io.setUp
  io.moved := unit.io.moved
  io.undrawn := unit.io.undrawn
  unit.io.draining := io.down.valid
  for ((bus, n) <- unit.io.stores.zipWithIndex) {
    bus.cmd.ready := !io.stall(n)
    bus.rsp.valid := Delay(bus.cmd.fire, latency, init = False)
    bus.rsp.payload := Delay(store.readSync(bus.cmd.address), latency - 1)
  }
}

/** A triangle, and the words of its store as docs/commands.md gives them, so that they do not follow the tables of
  * [[frustum.contract.raster]]. A store word is two words of the wire, the first in the upper half. With 1024 vertices
  * and 1024 triangles, word k of vertex i is at 0x400 k + i, state i at 0x1400 + i, word k of triangle i at 0x1800 + 2
  * i + k.
  */
private object HandWritten {

  /** By index; s and t in units of 2^-16 repeats. */
  val vertices: Seq[(Int, PackedVertex)] = Seq(
    0x005 -> PackedVertex(0x010, 0x020, 0x1234, 0x8000, 16, 0, 0, 0x11, 0x22, 0x33, 0x44),
    0x123 -> PackedVertex(0x390, 0x030, 0x2345, 0x9000, 15, 0xa000, -0x8000, 0x55, 0x66, 0x77, 0x88),
    0x2a7 -> PackedVertex(0x100, 0x240, 0x4567, 0xa000, 16, -0x14000, 0x18000, 0x99, 0xaa, 0xbb, 0xcc)
  )

  val state: RenderState = RenderState(
    Some(TextureRef(base = 5, log2Width = 5, log2Height = 6, TexelFormat.Rgba4444)),
    Wrap.Clamp,
    Wrap.Mirror,
    Combine.Modulate,
    DepthFunction.LessEq,
    depthWrite = true,
    blend = true,
    alphaRef = 9
  )

  val image: Map[Int, Long] = Map(
    // x, y | z, qMantissa | qExponent << 27, s in bits 24..0 | frame 0x55 << 25, t in bits 24..0 | r, g, b, a
    0x0005 -> 0x00100020L,
    0x0405 -> 0x12348000L,
    0x0805 -> 0x80000000L, // 16 << 27, s = 0
    0x0c05 -> 0xaa000000L, // t = 0
    0x1005 -> 0x11223344L,
    0x0123 -> 0x03900030L,
    0x0523 -> 0x23459000L,
    0x0923 -> 0x7800a000L, // 15 << 27, s = 0xa000
    0x0d23 -> 0xabff8000L, // t = 2^25 - 0x8000
    0x1123 -> 0x55667788L,
    0x02a7 -> 0x01000240L,
    0x06a7 -> 0x4567a000L,
    0x0aa7 -> 0x81fec000L, // 16 << 27, s = 2^25 - 0x14000
    0x0ea7 -> 0xaa018000L, // t = 0x18000
    0x12a7 -> 0x99aabbccL,
    // State 11. First half: RGBA4444 1 << 15, height 6 - 3 << 12, width 5 - 3 << 9, base 5. Second half: alpha
    // reference 9 << 11, blend 1 << 10, depth write 1 << 9, less or equal 3 << 6, modulate 2 << 4, mirror 2 << 2, clamp
    // 1.
    0x140b -> 0xb4054ee9L,
    // v0 = 5 << 20, v1 = 0x123 << 10, v2 = 0x2a7
    0x1800 -> 0x00548ea7L,
    // State 11 << 28. Tiles of 16 x 16 pixels: columns 0 to 3 (<< 10), as x is 1 to 57 pixels; rows 0 to 2, y is 2 to
    // 36.
    0x1801 -> 0xb0000c02L
  )
}

class RasterizerTest extends AnyFunSuite with Simulated {

  /** Words of a bank of the store, as the decoder lays them down. */
  private def image(pass: FramePass, config: RasterConfig): Map[Int, BigInt] = {
    val layout = StoreLayout(config)
    def unsigned(words: Seq[Int]) = words.map(w => BigInt(w & 0xffffffffL))
    val vertices = for {
      (v, i) <- pass.vertices.zipWithIndex
      (w, k) <- unsigned {
        import StoredVertex._
        encode(
          X -> v.x,
          Y -> v.y,
          Z -> v.z,
          QMantissa -> v.qMantissa,
          QExponent -> v.qExponent,
          S -> v.s,
          Tag -> pass.frame % 128,
          T -> v.t,
          R -> v.r,
          G -> v.g,
          B -> v.b,
          A -> v.a
        )
      }.zipWithIndex
    } yield layout.vertex(i, k) -> w
    val triangles = for ((t, i) <- pass.triangles.zipWithIndex) yield {
      val v = Seq(t.v0, t.v1, t.v2).map(pass.vertices)
      def tiles(at: PackedVertex => Int, size: Int, log2: Int) = {
        val (first, last) = ((v.map(at).min - 8 + 15) >> 4, (v.map(at).max - 8) >> 4)
        (
          scala.math.max(first, 0) >> log2,
          scala.math.min(last, size - 1) >> log2,
          first > last || last < 0 || first >= size
        )
      }
      val (x0, x1, noX) = tiles(_.x, config.width, config.tileLog2Width)
      val (y0, y1, noY) = tiles(_.y, config.height, config.tileLog2Height)
      val box = if (noX || noY) Seq(31, 0, 31, 0) else Seq(x0, x1, y0, y1)
      import StoredTriangle.{box => boxFields, _}
      val words = encode(Seq(V0 -> t.v0, V1 -> t.v1, V2 -> t.v2, State -> t.state) ++ boxFields.zip(box): _*)
      unsigned(words).zipWithIndex.map { case (w, k) => layout.triangle(i, k) -> w }
    }
    val states = for ((s, i) <- pass.states.zipWithIndex) yield {
      val words = StoredState.encode(RenderStateLayout.fields.map(f => StoredState.of(f) -> f.of(s.words)): _*)
      unsigned(words).zipWithIndex.map { case (w, k) => layout.state(i, k) -> w }
    }
    (vertices ++ triangles.flatten ++ states.flatten).toMap
  }

  private val benches = collection.mutable.Map.empty[Any, SimCompiled[RasterizerBench]]
  private def compiled(config: RasterConfig, latency: Int) = benches.getOrElseUpdate(
    (config, latency), {
      val (screen, tile) = (s"${config.width}x${config.height}", s"${config.tileWidth}x${config.tileHeight}")
      FrustumSim.compile(s"RasterizerBench_${screen}_${tile}_${config.slots}_$latency")(RasterizerBench(
        config,
        latency
      ))
    }
  )

  /** Compares, and tells how many triangles face away or have no area. */
  private def check(
      config: RasterConfig,
      latency: Int,
      passes: Seq[FramePass],
      stalls: Seq[Double],
      seed: Int,
      image: FramePass => Map[Int, BigInt]
  ): Int = {
    val expected = ArrayBuffer.empty[String]
    passes.foreach { pass =>
      model.raster.Rasterizer(config).draw(
        pass,
        new model.raster.FragmentSink {
          def tile(x: Int, y: Int): Unit = ()
          def fragment(
              n: Int,
              st: RenderState,
              x: Int,
              y: Int,
              s: Int,
              t: Int,
              q: Int,
              z: Int,
              r: Int,
              g: Int,
              b: Int,
              a: Int
          ): Unit =
            expected += (RenderStateLayout.fields.map(_.of(st.words)) ++ Seq(
              x,
              y,
              s,
              t,
              q,
              z,
              r,
              g,
              b,
              a
            )).mkString(" ")
          def tileEnd(x: Int, y: Int): Unit = expected += "end"
        }
      )
    }
    val undrawnOfEach = passes.map(model.raster.UndrawnTriangles(config, _).length)
    compiled(config, latency).doSim(seed) { dut =>
      for (rate <- stalls) {
        val got = ArrayBuffer.empty[String]
        var clocks, undrawn = 0
        dut.clockDomain.onSamplings {
          clocks += 1
          if (dut.io.undrawn.toBoolean) undrawn += 1
        }
        dut.io.frame.valid #= false
        dut.io.stall #= 0
        StreamReadyRandomizer(dut.io.down, dut.clockDomain).setFactor((2 - rate).toFloat)
        StreamReadyRandomizer(dut.io.tile, dut.clockDomain)
        StreamMonitor(dut.io.down, dut.clockDomain) { f =>
          got += (if (f.tileEnd.toBoolean) "end"
                  else {
                    val state = RenderStateLayout.fields.map(dut.io.state.value(_) match {
                      case flag: Bool        => if (flag.toBoolean) 1 else 0
                      case number: BitVector => number.toInt
                    })
                    (state ++ Seq(f.x, f.y).map(_.toInt) ++
                      Seq(f.s, f.t, f.q, f.z, f.r, f.g, f.b, f.a).map(_.toInt)).mkString(" ")
                  })
        }
        dut.clockDomain.forkStimulus(10)
        SimTimeout(20000000)
        if (rate > 0)
          dut.clockDomain.onSamplings {
            dut.io.stall #= (0 until 3).map(n => if (simRandom.nextDouble() < rate) 1 << n else 0).sum
          }
        passes.zipWithIndex.foreach { case (pass, n) =>
          image(pass).foreach { case (at, w) =>
            dut.store.setBigInt(((n & 1) << (StoreLayout(config).addressBits - 1)) + at, w)
          }
          dut.clockDomain.waitSampling()
          val f = dut.io.frame
          f.bank #= n & 1
          f.triangleCount #= pass.triangles.length
          f.clearColor #= 0
          f.x0 #= pass.region.x0; f.x1 #= pass.region.x1; f.y0 #= pass.region.y0; f.y1 #= pass.region.y1
          f.valid #= true
          dut.clockDomain.waitSamplingWhere(f.ready.toBoolean)
          f.valid #= false
        }
        dut.clockDomain.waitSampling(100)
        info(s"$clocks clocks, ${got.length} fragments and tile ends")
        val wrong = got.indices.find(i => i >= expected.length || got(i) != expected(i))
        wrong.foreach(i => fail(s"seed $seed stalls $rate fragment $i: got ${got(i)}, should be ${expected.lift(i)}"))
        assert(got.length == expected.length, s"seed $seed stalls $rate")
        assert(got.exists(_ != "end"), s"seed $seed stalls $rate: no fragment")
        assert(
          undrawn == undrawnOfEach.sum,
          s"seed $seed stalls $rate: triangles that face away or have no area, $undrawnOfEach"
        )
      }
    }
    undrawnOfEach.sum
  }

  private def randomPass(r: Random, config: RasterConfig, frame: Int, count: Int): FramePass = {
    val vertices = IndexedSeq.fill(3 * count)(0).indices.map { i =>
      val span = 1 << r.between(4, 13)
      val (cx, cy) = (r.nextInt(config.width * 16), r.nextInt(config.height * 16))
      def clip(v: Int) = scala.math.max(-PackedVertex.MaxXy, scala.math.min(PackedVertex.MaxXy, v))
      PackedVertex(
        clip(cx + r.between(-span, span)),
        clip(cy + r.between(-span, span)),
        r.nextInt(65536),
        r.between(32768, 65536),
        r.between(10, 20),
        r.between(-PackedVertex.MaxSt, PackedVertex.MaxSt + 1),
        r.between(-PackedVertex.MaxSt, PackedVertex.MaxSt + 1),
        r.nextInt(256),
        r.nextInt(256),
        r.nextInt(256),
        r.nextInt(256)
      )
    }
    val states = IndexedSeq(RenderState(), RenderState(blend = true, alphaRef = 3))
    FramePass(
      frame,
      0,
      TileRegion.whole(config),
      states,
      vertices,
      IndexedSeq.tabulate(count)(i => PackedTriangle(r.nextInt(2), 3 * i, 3 * i + 1, 3 * i + 2))
    )
  }

  private val usual = RasterConfig(width = 72, height = 40)
  private val smallest = RasterConfig(width = 41, height = 27, tileLog2Width = 3, tileLog2Height = 3, slots = 3)
  private val odd = RasterConfig(width = 97, height = 50, tileLog2Width = 5, tileLog2Height = 3, slots = 5)
  for ((config, latency) <- Seq((usual, 2), (smallest, 1), (odd, 3)))
    test(
      s"fragments equal the model's, tiles of ${config.tileWidth} x ${config.tileHeight}, ${config.slots} slots, " +
        s"store answers after $latency clocks"
    ) {
      val seed = 7
      val r = new Random(seed)
      val undrawn = check(
        config,
        latency,
        Seq(randomPass(r, config, 0, 5), randomPass(r, config, 1, 30), randomPass(r, config, 2, 3)),
        Seq(0.0, 0.4),
        seed,
        image(_, config)
      )
      assert(undrawn > 0, "every triangle is drawn")
    }

  test("fragments equal the model's for slivers, needles, huge and degenerate triangles") {
    val seed = 8
    val hard = new HardTriangles(usual, new Random(seed))
    val undrawn = check(usual, 2, (0 to 2).map(hard.pass(4 * hard.kinds.size, _)), Seq(0.0), seed, image(_, usual))
    assert(undrawn > 0, "every triangle is drawn")
  }

  test("fragments equal the model's where the store's words are written by hand") {
    val states = IndexedSeq.fill(11)(RenderState()) :+ HandWritten.state
    // The model takes vertices by index; the hardware gets no words of those that the triangle does not name.
    val vertices = HandWritten.vertices.foldLeft(IndexedSeq.fill(680)(HandWritten.vertices.head._2)) {
      case (all, (index, vertex)) => all.updated(index, vertex)
    }
    val triangle = PackedTriangle(state = 11, 5, 0x123, 0x2a7)
    val pass = FramePass(0x55, 0, TileRegion.whole(usual), states, vertices, IndexedSeq(triangle))
    check(usual, 2, Seq(pass), Seq(0.0), seed = 9, _ => HandWritten.image.map { case (at, w) => at -> BigInt(w) })
  }
}
