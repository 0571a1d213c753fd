package frustum.ray

import frustum.contract.ray.{RayCamera, RayScene}
import frustum.contract.video.VideoMode
import frustum.harness.FrustumSim
import frustum.model.ray.{RayPicture, RayPixel => ModelPixel}
import frustum.ray.scene.RayConfig
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

/** Ray caster with `expected`, when its result is due by the latency that it tells. */
class TimedRay(config: RayConfig) extends RayPipeline(config) {
  val expected = out(Bool())
  expected := Delay(io.up.valid, latency, init = False)
}

/** Whole frames of hardware and model, pixel by pixel, and the latency that the design tells. */
trait RayEquality {

  def compare(
      name: String,
      scene: RayScene,
      frames: Int,
      seed: Int,
      mode: VideoMode = RayEquality.mode,
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
}

object RayEquality {

  /** A small picture with blanks long enough for the set-up. */
  val mode: VideoMode =
    VideoMode("280x12", 25.175, 280, 12, 16, 96, 400, 40, 40, 120, hPositive = false, vPositive = false)
}
