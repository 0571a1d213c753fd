package frustum.referee

import frustum.command.pong.PongScenes
import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.RayCamera
import frustum.contract.video.VideoMode
import frustum.scene.RaySceneFile
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** What docs/rays.md and docs/pong.md promise of a ray caster's camera: x to the right, y upwards, z ahead. */
class RayContractTest extends AnyFunSuite {

  /** The ray through the centre of pixel (h, v) of a screen plane `focal` pixels ahead. */
  private def through(h: Int, v: Int, width: Int, height: Int, focal: Double) =
    Vec(h + 0.5 - width / 2.0, height / 2.0 - v - 0.5, focal).unit

  private def direction(c: RayCamera, h: Int, v: Int) = {
    val Seq(x, y, z) = (0 to 2).map(a => c.corner(a).toDouble + h * c.right(a) + v * c.down(a))
    Vec(x, y, z).unit
  }

  private def check(c: RayCamera, width: Int, height: Int, focal: Double): Unit =
    for (h <- Seq(0, 1, width / 2, width - 1); v <- Seq(0, height / 3, height - 1)) {
      assert((direction(c, h, v) - through(h, v, width, height, focal)).length < 1e-9, s"pixel ($h, $v)")
      val d = c.direction(h, v)
      assert((Vec(d.x.toDouble, d.y.toDouble, d.z.toDouble).unit - direction(c, h, v)).length < 1e-12)
    }

  test("a camera that looks along +z") {
    for ((width, height) <- Seq((640, 480), (800, 600)))
      check(RayCamera.forward(IntVector(0, 0, 0), width, height, 321), width, height, 321)
  }

  test("pong's room is as wide as the screen at its front") {
    for (mode <- Seq(VideoMode.Vga640x480)) {
      val scene = PongScenes.room(mode)
      val c = scene.camera.low
      // Edges of the screen lie half a pixel beyond the centres of its first and last column.
      for ((h, x) <- Seq(-0.5 -> scene.room.low.x, mode.width - 0.5 -> scene.room.high.x)) {
        val slope = (c.corner.x + h * c.right.x) / c.corner.z
        assert((c.eye.x - slope * c.eye.z - x).abs <= 1, s"at column $h")
      }
    }
  }

  test("a scene file's camera") {
    val file = Files.createTempFile("scene", ".json")
    Files.writeString(file, """{"camera": {"eye": [0, 0, -320], "focal": 320}}""")
    val mode = VideoMode.Vga640x480
    val scene = RaySceneFile.read(file, PongScenes.room(mode), mode.width, mode.height)
    assert(scene.camera.low.eye == IntVector(0, 0, -320))
    check(scene.camera.low, mode.width, mode.height, 320)
  }
}
