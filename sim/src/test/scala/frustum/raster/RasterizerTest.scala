package frustum.raster

import frustum.contract.raster.{
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
  TileRegion
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
      val name =
        s"RasterizerBench_${config.width}x${config.height}_${config.tileWidth}x${config.tileHeight}_${config.slots}_$latency"
      FrustumSim.compile(name)(RasterizerBench(config, latency))
    }
  )

  private def check(
      config: RasterConfig,
      latency: Int,
      passes: Seq[FramePass],
      stalls: Seq[Double],
      seed: Int
  ): Unit = {
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
          image(pass, config).foreach { case (at, w) =>
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
        val due = passes.map(model.raster.UndrawnTriangles(config, _).length)
        assert(due.exists(_ > 0), s"seed $seed: every triangle is drawn")
        assert(undrawn == due.sum, s"seed $seed stalls $rate: triangles that face away or have no area, $due")
      }
    }
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
      s"fragments equal the model's, tiles of ${config.tileWidth} x ${config.tileHeight}, ${config.slots} slots, store answers after $latency clocks"
    ) {
      val seed = 7
      val r = new Random(seed)
      check(
        config,
        latency,
        Seq(randomPass(r, config, 0, 5), randomPass(r, config, 1, 30), randomPass(r, config, 2, 3)),
        Seq(0.0, 0.4),
        seed
      )
    }

  test("fragments equal the model's for slivers, needles, huge and degenerate triangles") {
    val seed = 8
    val hard = new HardTriangles(usual, new Random(seed))
    check(usual, 2, (0 to 2).map(hard.pass(4 * hard.kinds.size, _)), Seq(0.0), seed)
  }
}
