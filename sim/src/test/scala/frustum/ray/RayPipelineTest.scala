package frustum.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayCamera, RayChecker, RayImage, RayScene, RaySolid, RaySphere}
import frustum.contract.video.VideoMode
import frustum.demos.pong.PongScene
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.ray.{RayPicture, RayPixel => ModelPixel}
import frustum.ray.scene.RayConfig
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.collection.mutable.ArrayBuffer
import scala.util.{Random, Try}

/** Ray caster with `expected`, when its result is due by the latency that it tells. */
class TimedRay(config: RayConfig) extends RayPipeline(config) {
  val expected = out(Bool())
  expected := Delay(io.up.valid, latency, init = False)
}

/** Hardware = model: whole frames, pixel by pixel, and the latency that the design tells. */
class RayPipelineTest extends AnyFunSuite {

  /** A small picture with blanks long enough for the set-up. */
  private val mode =
    VideoMode("280x12", 25.175, 280, 12, 16, 96, 400, 40, 40, 120, hPositive = false, vPositive = false)

  private def compare(
      name: String,
      scene: RayScene,
      frames: Int,
      seed: Int,
      mode: VideoMode = mode,
      camera: Random => Option[RayCamera] = _ => None,
      fast: Boolean = false
  ): Unit = {
    val random = new Random(seed)
    val motions = Seq.fill(frames)(RandomScenes.motion(scene, random).copy(camera = camera(random)))
    val model = new RayPicture(scene, mode.width, mode.height)
    FrustumSim.compile(s"RayPipeline_$name")(new TimedRay(RayConfig(scene, mode, fast))).doSim(name, seed) { dut =>
      SimTimeout(100L * 1000 * 1000)
      dut.clockDomain.forkStimulus(10)
      dut.io.latch #= false
      dut.io.line #= false
      dut.io.up.valid #= false
      val seen = ArrayBuffer[ModelPixel]()
      dut.clockDomain.onSamplings {
        assert(
          dut.io.down.valid.toBoolean == dut.expected.toBoolean,
          s"latency is not ${dut.latency}, seed $seed"
        )
        if (dut.io.down.valid.toBoolean) {
          val c = dut.io.down.rgb
          seen += ModelPixel(c.r.toInt << 16 | c.g.toInt << 8 | c.b.toInt, dut.io.down.objectId.toInt)
        }
      }
      dut.clockDomain.waitSampling(5)
      for ((m, f) <- motions.zipWithIndex) {
        for ((p, v) <- dut.io.motion.spheres.zip(m.spheres) ++ dut.io.motion.quads.zip(m.quads)) {
          p.x #= v.x; p.y #= v.y; p.z #= v.z
        }
        for (c <- m.camera; (p, v) <- dut.io.motion.camera.zip(c.vectors)) {
          p.x #= v.x; p.y #= v.y; p.z #= v.z
        }
        dut.io.latch #= true
        dut.clockDomain.waitSampling()
        dut.io.latch #= false
        dut.clockDomain.waitSampling(dut.takeClocks)
        for (p <- dut.io.motion.spheres ++ dut.io.motion.quads) {
          p.x.randomize(); p.y.randomize(); p.z.randomize()
        }
        dut.clockDomain.waitSampling(dut.setUpClocks)
        seen.clear()
        for (y <- 0 until mode.height) {
          dut.io.line #= true
          dut.clockDomain.waitSampling()
          dut.io.line #= false
          dut.clockDomain.waitSampling(dut.lineClocks)
          for (x <- 0 until mode.width) {
            dut.io.up.valid #= true
            dut.clockDomain.waitSampling()
          }
          dut.io.up.valid #= false
          dut.clockDomain.waitSampling(mode.hTotal - dut.lineClocks - mode.width - 1)
        }
        val want = model(m)
        assert(seen.size == want.length)
        for ((w, i) <- want.zipWithIndex)
          assert(
            seen(i) == w,
            s"frame $f pixel (${i % mode.width}, ${i / mode.width}) of $name, seed $seed, $m"
          )
      }
    }
  }

  private val pong = PongScene.room(mode.width, mode.height, 3)

  test("pong", Simulated)(compare("pong", pong, 8, 1))
  test("pong, with registers for a higher clock", Simulated)(compare("fast", pong, 4, 11, fast = true))
  test("pong, its puck not shaded", Simulated)(compare("flat", pong.copy(shaded = false), 3, 7))
  test("two spheres, of which the nearer one's shade is shown", Simulated) {
    val puck = pong.spheres.head
    val pillar = RaySphere(IntVector(-40, -60, 560), IntVector(-40, -60, 560), 30, 0x40c0ff)
    // The puck stays before the pillar.
    val wide = mode.copy(name = "400x12", width = 400)
    compare("two", pong.copy(spheres = Seq(pillar, puck.copy(high = puck.high.copy(z = 400)))), 4, 8, wide)
  }
  test("a camera that moves and turns", Simulated) {
    val scene = RandomScenes.moving(mode.width, mode.height, 3, inside = true)
    compare(
      "moving",
      scene,
      4,
      9,
      camera = r => Some(RandomScenes.camera(scene, r, mode.width, mode.height, 3))
    )
  }
  test("images on walls and quads, solid walls", Simulated) {
    val random = new Random(10)
    def image(w: Int, h: Int, bits: Int) =
      RayImage(w, h, bits, IndexedSeq.fill(w * h)(random.nextInt(1 << 24)))
    val (small, shared) = (image(8, 4, 3), image(16, 16, 5))
    val paints = Seq(shared, RaySolid(0x8040c0), shared, RayChecker(4), small)
    val scene = pong.copy(
      room = pong.room.copy(paints = paints),
      quads = pong.quads.map(_.copy(paint = image(32, 32, 2)))
    )
    compare("images", scene, 3, 10)
  }
  test("no sphere", Simulated)(compare("noSphere", pong.copy(spheres = Nil), 2, 2))
  test("no light", Simulated)(compare("noLight", pong.copy(light = None), 3, 3))

  test("random scenes, oriented cameras", Simulated) {
    val wide = mode.copy(name = "400x12", width = 400)
    for (seed <- 4 to 6) {
      val random = new Random(seed)
      // Some need more than 64 bits in a picture of this width, and are refused.
      val scene = Iterator
        .continually(RandomScenes.scene(random, wide.width, wide.height))
        .find(s => s.spheres.size == 1 && s.light.isDefined && Try(RayConfig(s, wide)).isSuccess)
        .get
      compare(s"random$seed", scene, 2, seed, wide)
    }
  }

  test("no sphere means no sphere logic") {
    val names = RayConfig(pong.copy(spheres = Nil), mode).program.forms.map(_.name)
    assert(!names.exists(n => Seq("sphere", "along", "shadow", "gate").exists(n.startsWith(_))), names)
  }
}
