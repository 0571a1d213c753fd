package frustum.voxel

import frustum.engine.VoxelSession
import frustum.host.VoxelView
import frustum.model.pipelines.VoxelModel
import frustum.scene.{Hills, VoxelWorld}
import frustum.spec.{Blocks, LeapField, VoxelConfig, WorldSize}
import org.joml.Vector3d
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** Pictures of the voxel pipeline against its model, every pixel. */
class VoxelPipelineTest extends AnyFunSuite {
  private val seed = 1

  private def views(c: VoxelConfig, random: Random, n: Int): Seq[VoxelView] = Seq.fill(n) {
    val eye = c.size.axes.map { size =>
      val e = random.nextInt(4) match {
        case 0 => random.between(-32.0, size + 32.0) // as far away as an eye may be
        case _ => random.between(-2.0, size + 2.0)
      }
      if (random.nextInt(4) == 0) e.round.toDouble else e // on a border of blocks
    }
    val (yaw, pitch) = random.nextInt(3) match {
      case 0 => (90.0 * random.nextInt(4), 90.0 * (random.nextInt(3) - 1)) // along the axes
      case _ => (random.between(0.0, 360.0), random.between(-90.0, 90.0))
    }
    VoxelView(new Vector3d(eye(0), eye(1), eye(2)), yaw, pitch, 0.9 * c.height)
  }

  private def equal(c: VoxelConfig, views: Seq[VoxelView], worlds: Seq[VoxelWorld]): Unit =
    VoxelSession.compile(c, Blocks.assets).doSim("equal", seed) { dut =>
      val session = new VoxelSession(dut)
      for (world <- worlds) {
        val model = new VoxelModel(c, Blocks.assets, world)
        session.load(model.words)
        for ((view, n) <- views.zipWithIndex) {
          val camera    = view.camera(c)
          val highlight = n % 2 == 0
          val pointedAt = model.pointedAt(camera, reach = 6)
          val pixels    = for (j <- 0 until c.height; i <- 0 until c.width)
            yield model.pixel(camera, i, j, pointedAt.filter(_ => highlight))
          val frame = session.frame(camera, highlight)
          val wrong = pixels.indices.filter(i => pixels(i).color != frame.picture(i))
          wrong.headOption.foreach { i =>
            fail(
              f"seed $seed, $view: ${wrong.length} pixels wrong, the first is $i: ${frame.picture(i)}%06x, " +
                f"should be ${pixels(i).color}%06x of ${pixels(i)}"
            )
          }
          assert(session.pointedAt == pointedAt.map(f => (Seq(f.x, f.y, f.z), f.face)), s"$view")
          val picking = model.pointedAtSteps(camera)
          val steps   = pixels.map(_.steps).sum + picking
          assert(frame.steps == steps, s"$view")
          // Alone in the ring: the ray that picks, and at the end perhaps the longest.
          val alone = Marcher.Slots * (picking + pixels.map(_.steps).max) + 100
          assert(frame.clocks <= steps / 0.98 + alone, s"$view: ${frame.clocks} clocks for $steps steps")
        }
      }
    }

  private def scatter(size: WorldSize, random: Random, density: Double) =
    VoxelWorld.tabulate(size)((_, _, _) => if (random.nextDouble() < density) 1 + random.nextInt(24) else 0)

  for (
    c <- Seq(
      VoxelConfig(size = WorldSize(16, 8, 16), width = 40, height = 32),
      VoxelConfig(
        size = WorldSize(16, 32, 8),
        width = 32,
        height = 24,
        leaps = LeapField.Octants,
        distance = 12,
        fog = false
      ),
      VoxelConfig(
        size = WorldSize(16, 16, 32),
        width = 17,
        height = 19,
        leaps = LeapField(0, 0),
        slopeBits = 13,
        eyeBits = 5
      ),
      VoxelConfig(
        size = WorldSize(4, 8, 64),
        width = 24,
        height = 16,
        leaps = LeapField(3, 4),
        slopeBits = 14,
        distance = 60
      )
    )
  ) test(s"pictures and steps are the model's, $c") {
    val random = new Random(seed)
    equal(c, views(c, random, 12), Seq(scatter(c.size, random, 0.05), scatter(c.size, random, 0.4)))
  }

  test("hills at the size of the Arty's world") {
    val c = VoxelConfig(width = 64, height = 48)
    equal(c, views(c, new Random(2), 8), Seq(Hills(c.size, 1)))
  }
}
