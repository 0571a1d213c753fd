package frustum.engine.raster

import frustum.bench.Workloads
import frustum.contract.raster.{FramePass, RasterConfig, TextureUpload}
import frustum.driver.raster.Driver
import frustum.engine.EngineSim
import frustum.harness.Simulated
import frustum.model.raster.UndrawnTriangles
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

class PipelineEngineTest extends AnyFunSuite with Simulated {
  private val odd = RasterConfig(width = 72, height = 40)
  private val smallest = RasterConfig(
    width = 40,
    height = 27,
    tileLog2Width = 3,
    tileLog2Height = 3,
    maxVertices = 200,
    maxTriangles = 200,
    textureTexels = 4096
  )

  private def simulate(
      config: RasterConfig,
      seed: Int,
      byteStall: Double = 0,
      pixelStall: Double = 0
  )(body: PipelineSession => Unit): Unit =
    EngineSim.run(PipelineEngine.compile(config), None, seed)(dut =>
      body(new PipelineSession(dut, seed, byteStall, pixelStall))
    )

  private def check(
      session: PipelineSession,
      config: RasterConfig,
      textures: Seq[TextureUpload],
      pass: FramePass,
      what: String
  ): DrawnPass = {
    val image = new Array[Int](config.width * config.height)
    val drawn = session.take(pass, image)
    Frames.assertEqual(config, image, Frames.model(config, textures, Seq(pass)), what)
    drawn
  }

  for (
    (config, count) <- Seq(odd -> 20, smallest -> 7); (byteStall, pixelStall) <- Seq((0.0, 0.0), (0.5, 0.5), (0.0, 0.8))
  )
    test(s"frames sent without a pause, ${config.width} x ${config.height}, stalls $byteStall and $pixelStall") {
      val seed = 5
      val random = new Random(seed)
      val texture = Frames.texture(random)
      val passes = (0 until 6).map(Frames.random(random, config, _, count))
      simulate(config, seed, byteStall, pixelStall) { session =>
        (Driver.commands(texture) ++ passes.flatMap(Driver.commands)).foreach(session.send)
        val undrawn = passes.map { p =>
          val drawn = check(session, config, Seq(texture), p, s"seed $seed, frame ${p.frame}")
          assert(drawn.undrawn == UndrawnTriangles(config, p).length, s"seed $seed, frame ${p.frame}")
          drawn.undrawn
        }
        assert(session.undrawn == undrawn.sum % 256 && undrawn.sum > 0, session.status)
        assert(!session.faulty, session.status)
      }
    }

  test("several passes, where a frame exceeds the store, equal one picture") {
    val frames = Frames.scene("terrain", smallest, frames = 2)
    assert(frames.forall(_.passes.length > 1), "the store is too large for this test")
    new PipelineEngine(EngineOptions(3, None), byteStall = 0.2, pixelStall = 0.3).drawAll(frames).zip(frames).foreach {
      case (drawn, frame) => Frames.assertEqual(smallest, drawn.image, Frames.model(frame), "seed 3")
    }
  }

  test("a texture sent while frames are drawn changes only those behind it") {
    val seed = 8
    val random = new Random(seed)
    val textures = Seq.fill(4)(Frames.texture(random))
    val passes = textures.indices.map(Frames.random(random, odd, _, 15))
    simulate(odd, seed, pixelStall = 0.4) { session =>
      textures.zip(passes).foreach { case (t, p) => (Driver.commands(t) ++ Driver.commands(p)).foreach(session.send) }
      textures.zip(passes).foreach { case (t, p) => check(session, odd, Seq(t), p, s"seed $seed, frame ${p.frame}") }
    }
  }

  /** Until nothing has happened for a while. */
  private def settle(session: PipelineSession): Unit = {
    var last = -1L
    while ({ val now = session.run(5000); val moving = now != last; last = now; moving }) ()
  }

  test("wrong, lost, surplus and missing bytes spoil one frame at most, and are told") {
    val seed = 11
    val random = new Random(seed)
    val texture = Frames.texture(random)
    simulate(odd, seed) { session =>
      Driver.commands(texture).foreach(session.send)
      for (trial <- 0 until 40) {
        val bytes = Driver.commands(Frames.random(random, odd, 2 * trial, 10)).flatten
        val at = random.nextInt(bytes.length)
        val bad = trial % 4 match {
          case 0 => bytes.updated(at, bytes(at) ^ (1 << random.nextInt(8)))
          case 1 => bytes.patch(at, Nil, 1 + random.nextInt(30))
          case 2 => bytes.patch(at, Seq.fill(1 + random.nextInt(30))(random.nextInt(256)), 0)
          case _ => bytes.take(at) // the host stops in mid-command
        }
        session.send(bad)
        settle(session)
        session.discard()
        val good = Frames.random(random, odd, 2 * trial + 1, 10)
        Driver.commands(good).foreach(session.send)
        check(session, odd, Seq(texture), good, s"seed $seed, trial $trial, byte $at")
      }
      assert(session.faulty, "nothing was told of all this")
    }
  }

  test("a reset in mid-frame leaves nothing behind") {
    val seed = 13
    val random = new Random(seed)
    val texture = Frames.texture(random)
    simulate(odd, seed) { session =>
      for (trial <- 0 until 12) {
        Driver.commands(texture).foreach(session.send)
        (0 until 3).foreach(i => Driver.commands(Frames.random(random, odd, i, 20)).foreach(session.send))
        session.run(random.between(100, 12000))
        session.reset()
        val good = Frames.random(random, odd, 5, 20)
        (Driver.commands(texture) ++ Driver.commands(good)).foreach(session.send)
        check(session, odd, Seq(texture), good, s"seed $seed, trial $trial")
        assert(!session.faulty, session.status)
      }
    }
  }

  test("320 x 240: a scene of hundreds of triangles") {
    val config = RasterConfig(width = 320, height = 240)
    val frame = Frames.scene("terrain", config)
    val drawn = new PipelineEngine(EngineOptions(1, None)).drawAll(frame).head
    Frames.assertEqual(config, drawn.image, Frames.model(frame.head), "terrain")
    info(s"${drawn.clocks.get} clocks")
  }

  test(
    "tiles are drawn while others are sent: a full-screen quad, textured and blended, a clock a pixel and little more"
  ) {
    val config = RasterConfig(width = 320, height = 240)
    val load = new Workloads(config, 1)
    simulate(config, 1) { session =>
      val passes = Seq.fill(2)(load.fullScreen)
      (Driver.commands(load.texture) ++ passes.flatMap(Driver.commands)).foreach(session.send)
      val clocks = passes.map(session.take(_, new Array[Int](config.width * config.height)).clocks).last
      info(f"${clocks.toDouble / (config.width * config.height)}%.3f clocks a pixel")
      assert(clocks <= 1.10 * config.width * config.height)
    }
  }

  test("a pipeline that stands still is told of") {
    val pass = Frames.random(new Random(1), odd, 0, 3)
    val fault = intercept[IllegalStateException](simulate(odd, 1) { session =>
      Driver.commands(pass).init.foreach(session.send) // draw is never sent
      session.take(pass, new Array[Int](odd.width * odd.height))
    })
    assert(fault.getMessage.contains("hangs"))
  }
}
