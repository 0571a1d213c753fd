package frustum.play

import frustum.driver.linear.Vector3
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.awt.event.KeyEvent._

/** Turning, zooming and lighting, without a window. */
class RasterViewTest extends AnyFunSuite {
  private val cube = Scenes.byName("cube")
  private val start = RasterView(cube, 0.75)
  private val none = Set.empty[Int]
  private def close(a: Vector3, b: Vector3) = assert(a.distance(b) < 1e-6, (a, b))
  private def distance(v: RasterView) = { val c = v.camera(0.75); c.eye.distance(c.at) }

  test("nothing pressed: the scene's own camera, without light") {
    val same = start.next(none, PointerMoves())
    assert(same == start && same.camera(0.75) == cube.camera && same.options.light.isEmpty)
  }

  test("a full turn comes back; half a turn is on the other side") {
    val half = (0 until 60).foldLeft(start)((v, _) => v.next(Set(VK_RIGHT), PointerMoves()))
    val (away, over) = (start.own.eye - start.own.at, half.camera(0.75).eye - half.own.at)
    close(Vector3(away.x, 0, away.z), Vector3(-over.x, 0, -over.z))
    close((0 until 60).foldLeft(half)((v, _) => v.next(Set(VK_RIGHT), PointerMoves())).camera(0.75).eye, start.own.eye)
  }

  test("the arrows and the mouse turn the same way, and no further than nearly above and below") {
    val right = start.next(Set(VK_RIGHT), PointerMoves())
    assert(right.yaw > 0 && start.next(none, PointerMoves(dragX = -10)).yaw > 0)
    val above = start.next(none, PointerMoves(dragY = 100000)).camera(0.75)
    assert(above.eye.y > start.own.eye.y)
    val sight = (above.eye - above.at).normalized
    assert(sight.dot(above.up.normalized) < 0.9999, "not along the up vector")
  }

  test("wheel and keys zoom, within limits") {
    assert(distance(start.next(none, PointerMoves(wheel = -3))) < distance(start))
    assert(distance(start.next(Set(VK_PLUS), PointerMoves())) < distance(start))
    assert(distance(start.next(Set(VK_MINUS), PointerMoves())) > distance(start))
    val far = start.next(none, PointerMoves(wheel = 1e6))
    assert((distance(far) / distance(start) - 20).abs < 1e-6)
    assert(far.camera(0.75).far > distance(far), "the far plane goes with it")
  }

  test("l and c switch once for each press; r starts again") {
    val lit = start.next(Set(VK_L), PointerMoves())
    assert(lit.light && lit.next(Set(VK_L), PointerMoves()).light, "still held")
    assert(!lit.next(none, PointerMoves()).next(Set(VK_L), PointerMoves()).light)
    val culled = lit.next(Set(VK_C), PointerMoves(dragX = 50))
    assert(culled.options.cullBack && culled.state.contains("light on"))
    val again = culled.next(Set(VK_R), PointerMoves()).next(none, PointerMoves())
    assert(again == start)
  }

  test("moving the light lights the mesh, to the right and upwards as it is moved") {
    val right = start.next(Set(VK_D), PointerMoves())
    val up = start.next(none, PointerMoves(otherY = -40))
    val still = start.next(Set(VK_L), PointerMoves()).options.light.get
    assert(right.options.light.get.x > still.x && up.options.light.get.y > still.y)
    assert((still.length - 1).abs < 1e-9)
  }
}
