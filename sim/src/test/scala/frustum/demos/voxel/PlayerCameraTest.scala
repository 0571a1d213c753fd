package frustum.demos.voxel

import frustum.contract.arithmetic.{IntVector, SineTable}
import frustum.contract.voxel.VoxelConfig
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.model.demos.voxel.{PlayerCamera, VoxelPlayer}
import org.scalatest.funsuite.AnyFunSuite
import scala.math.sin

/** The camera made of whole numbers against the one that a host reckons with floating point. */
class PlayerCameraTest extends AnyFunSuite {
  test("sines are the rounded ones, coarse ones as well") {
    for (a <- -1024 until 2048) {
      val exact = sin(a * 2 * scala.math.Pi / 1024)
      assert((SineTable.sine(a) - exact * 65536).abs <= 0.5001, s"angle $a")
      assert((SineTable.coarse(a) - exact * 256).abs <= 0.502, s"angle $a")
    }
  }

  for ((width, height) <- Seq((320, 240), (160, 120))) test(s"directions are within 1/50 pixel, ${width}x$height") {
    val c = VoxelConfig(width = width, height = height)
    val focal = 225.0 * height / 240
    val program = CameraProgram(width, height, focal)
    var worst = 0.0
    for (yaw <- 0 until 1024 by 37; pitch <- -248 to 248 by 31) {
      val player = VoxelPlayer(IntVector(1000, 2000, 3000), yaw, pitch)
      val camera = PlayerCamera(player, c, program)
      val ideal = VoxelView(Vector3.Zero, yaw * 360 / 1024.0, pitch * 360 / 1024.0, focal)
      for (i <- Seq(0, 97, width - 1); j <- Seq(0, 71, height - 1)) {
        val Seq(x, y, z) = camera.direction(i, j).map(_.toDouble)
        val d = Vector3(x, y, z)
        // Back onto the screen, pixels from the ideal place.
        val depth = d.dot(ideal.look)
        val right = d.dot(ideal.right) / depth * focal - (i + 0.5 - width / 2.0)
        val up = d.dot(ideal.up) / depth * focal - (height / 2.0 - j - 0.5)
        worst = worst.max(right.abs).max(up.abs)
      }
      assert(camera.eye == IntVector(1000, 2000, 3000 + VoxelRules.EyeHeight))
    }
    info(f"largest error $worst%.4f pixels")
    assert(worst <= 0.02)
  }
}
