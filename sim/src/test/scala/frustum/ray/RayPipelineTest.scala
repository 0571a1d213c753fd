package frustum.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayChecker, RayImage, RaySolid, RaySphere}
import frustum.demos.pong.PongScene
import frustum.harness.Simulated
import frustum.ray.scene.RayConfig
import org.scalatest.funsuite.AnyFunSuite

import scala.util.{Random, Try}

/** Hardware = model: whole frames, pixel by pixel, and the latency that the design tells. */
class RayPipelineTest extends AnyFunSuite with RayEquality {
  import RayEquality.mode
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
