package frustum.ray

import frustum.harness.FrustumSim
import frustum.model.ray.{RayPicture, RayPixel => ModelPixel}
import frustum.spec._
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

/** Hardware = model: whole frames, pixel by pixel, and the latency that the design tells. */
class RayPipelineTest extends AnyFunSuite {
  private val mode = VideoMode.Test40x30.copy(width = 200, height = 12, hBack = 400, vBack = 120)

  private def compare(name: String, scene: RayScene, frames: Int, seed: Int): Unit = {
    val random = new Random(seed)
    val motions = Seq.fill(frames)(RandomScenes.motion(scene, random))
    val model = new RayPicture(scene, mode.width, mode.height)
    FrustumSim.compile(s"RayPipeline_$name")(RayPipeline(RayConfig(scene, mode))).doSim(name, seed) { dut =>
      SimTimeout(100L * 1000 * 1000)
      dut.clockDomain.forkStimulus(10)
      dut.io.latch #= false
      dut.io.line #= false
      dut.io.up.valid #= false
      val seen = ArrayBuffer[(Long, ModelPixel)]()
      var clock = 0L
      var start: Option[Long] = None
      dut.clockDomain.onSamplings {
        clock += 1
        if (dut.io.up.valid.toBoolean && start.isEmpty) start = Some(clock)
        if (dut.io.down.valid.toBoolean) {
          val c = dut.io.down.rgb
          seen += ((clock, ModelPixel(c.r.toInt << 16 | c.g.toInt << 8 | c.b.toInt, dut.io.down.objectId.toInt)))
        }
      }
      dut.clockDomain.waitSampling(5)
      for ((m, f) <- motions.zipWithIndex) {
        for ((p, v) <- dut.io.motion.spheres.zip(m.spheres) ++ dut.io.motion.quads.zip(m.quads)) {
          p.x #= v.x; p.y #= v.y; p.z #= v.z
        }
        dut.io.latch #= true
        dut.clockDomain.waitSampling()
        dut.io.latch #= false
        for (p <- dut.io.motion.spheres ++ dut.io.motion.quads) { p.x.randomize(); p.y.randomize(); p.z.randomize() }
        dut.clockDomain.waitSampling(dut.setUpClocks)
        seen.clear()
        start = None
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
        }
        dut.clockDomain.waitSampling(20)
        println(s"start $start first ${seen.take(3)} count ${seen.size}")
        assert(seen.head._1 - start.get == dut.latency, s"latency told as ${dut.latency}, seed $seed")
        val want = model(m)
        assert(seen.size == want.length)
        for ((w, i) <- want.zipWithIndex)
          assert(seen(i)._2 == w, s"frame $f pixel (${i % mode.width}, ${i / mode.width}) of $name, seed $seed, $m")
      }
    }
  }

  private val pong = PongScene.room(mode.width, mode.height, 3)

  test("pong")(compare("pong", pong, 8, 1))
  test("no sphere")(compare("noSphere", pong.copy(spheres = Nil), 2, 2))
  test("no light")(compare("noLight", pong.copy(light = None), 3, 3))

  test("no sphere means no sphere logic") {
    val names = RayConfig(pong.copy(spheres = Nil), mode).program.forms.map(_.name)
    assert(!names.exists(n => Seq("sphere", "along", "shadow", "gate").exists(n.startsWith(_))), names)
  }
}
