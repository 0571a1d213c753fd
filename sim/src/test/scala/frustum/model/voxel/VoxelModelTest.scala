package frustum.model.voxel

import frustum.contract.arithmetic.IntVector
import frustum.contract.voxel.{LeapField, VoxelCamera, VoxelConfig, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.judge.{VoxelCounts, VoxelJudge}
import frustum.model.voxel.wide.{FaceTexel, VoxelRaySetup}
import frustum.reference.voxel.IdealVoxelPicture
import frustum.scene.{Hills, VoxelWorld}
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** The model's rays against exact marching. */
class VoxelModelTest extends AnyFunSuite {
  private val small = VoxelConfig(size = WorldSize(16, 32, 8), width = 32, height = 24)
  private val fields =
    Seq(LeapField.UpDown, LeapField.Octants, LeapField(0, 3), LeapField(5, 4), LeapField(0, 0))

  private def scatter(size: WorldSize, random: Random, density: Double) =
    VoxelWorld.tabulate(size)((_, _, _) => if (random.nextDouble() < density) 1 + random.nextInt(24) else 0)

  /** Rays in all directions from all kinds of places, many of them where borders meet. */
  private def rays(c: VoxelConfig, random: Random, n: Int): Seq[(IntVector, IntVector)] = Seq.fill(n) {
    val one = 1 << c.eyeBits
    val eye = c.size.axes.map { size =>
      val whole = random.between(-4, size + 5) * one
      if (random.nextInt(3) == 0) whole else whole + random.nextInt(one)
    }
    val full = 1 << VoxelCamera.DirectionBits
    val direction = random.nextInt(3) match {
      case 0 => Seq.fill(3)(random.between(-full, full))
      case 1 => Seq.fill(3)((random.nextInt(5) - 2) * full / 2) // along axes and through edges and corners
      case 2 => Seq.fill(3)(random.nextInt(9) - 4).map(_ * full / 4)
    }
    val reached =
      if (direction.forall(_.abs < full / 2)) direction.updated(random.nextInt(3), full) else direction
    (IntVector(eye(0), eye(1), eye(2)), IntVector(reached(0), reached(1), reached(2)))
  }

  for (field <- fields) test(s"rays anywhere see what exact marching sees, $field") {
    val seed = 1
    val random = new Random(seed)
    for (density <- Seq(0.01, 0.1, 0.5)) {
      val c = small.copy(leaps = field, distance = 14)
      val model = new VoxelModel(c, Blocks.assets, scatter(c.size, random, density))
      val judge = new VoxelJudge(model)
      for ((eye, d) <- rays(c, random, 4000)) {
        val camera = VoxelCamera(eye, d, d, IntVector(0, 0, 0), IntVector(0, 0, 0))
        val counts = judge.ray(camera, model.pixel(camera, 0, 0))
        assert(counts.failures.isEmpty, s"eye $eye, direction $d, density $density, seed $seed")
      }
    }
  }

  test("hills: leaps take at most 1 / 2.2 of plain marching's steps up and down, 1 / 2.6 by octants") {
    for ((field, most) <- Seq(LeapField.UpDown -> 1 / 2.2, LeapField.Octants -> 1 / 2.6)) {
      val c = VoxelConfig(width = 40, height = 30, leaps = field)
      val counts = for (seed <- 1 to 3; yaw <- 0 until 360 by 60) yield {
        val model = new VoxelModel(c, Blocks.assets, Hills(c.size, seed))
        val view = VoxelView(Vector3(30.3, 31.6, 24), yaw + 7, -15, 225 / 8.0)
        val camera = view.camera(c)
        val pixels = for (j <- 0 until c.height; i <- 0 until c.width) yield model.pixel(camera, i, j)
        new VoxelJudge(model).picture(camera, view, pixels)
      }
      val sum = counts.reduce(_ + _)
      info(
        f"$field: ${sum.plainSteps.toDouble / sum.rays}%.2f steps a ray plain, ${sum.steps.toDouble / sum.rays}%.2f " +
          "leaping"
      )
      assert(sum.failures.isEmpty)
      assert(sum.steps <= sum.plainSteps * most)
    }
  }

  test("directions are within 1/16 pixel of the ideal camera's") {
    val c = VoxelConfig()
    val random = new Random(3)
    val model =
      new VoxelModel(c, Blocks.assets, VoxelWorld.tabulate(c.size)((_, _, z) => if (z == 0) 1 else 0))
    val worst =
      Seq.fill(40)((random.nextDouble() * 360, random.nextDouble() * 180 - 90)).map { case (yaw, pitch) =>
        val view = VoxelView(Vector3(32, 32, 16), yaw, pitch, 225)
        val camera = view.camera(c)
        val ideal = IdealVoxelPicture.rays(view, c)
        (for (j <- 0 until c.height by 7; i <- 0 until c.width by 7) yield {
          val ray = VoxelRaySetup(camera.eye.axes, camera.direction(i, j), c)
          VoxelJudge.error(ideal, i, j, ray, c)
        }).max
      }.max
    info(f"largest error $worst%.4f pixels")
    assert(worst <= 1.0 / 16)
  }

  test("texels are within their face, also in edges and corners") {
    val c = small
    val model = new VoxelModel(c, Blocks.assets, scatter(c.size, new Random(5), 0.3))
    for ((eye, d) <- rays(c, new Random(6), 5000)) {
      val camera = VoxelCamera(eye, d, d, IntVector(0, 0, 0), IntVector(0, 0, 0))
      for (f <- model.pixel(camera, 0, 0).seen)
        assert(f.u >= 0 && f.u < 16 && f.v >= 0 && f.v < 16, s"$eye $d")
    }
  }
}
