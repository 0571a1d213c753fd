package frustum.voxel

import frustum.contract.voxel.{LeapField, VoxelConfig, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.driver.voxel.VoxelView
import frustum.engine.voxel.VoxelSession
import frustum.harness.Simulated
import frustum.model.voxel.VoxelModel
import frustum.scene.{Hills, VoxelWorld}
import frustum.voxel.march.MarcherStages
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** Pictures of the voxel pipeline against its model, every pixel. */
class VoxelPipelineTest extends AnyFunSuite with Simulated {
  private val seed = 1

  private def equal(c: VoxelConfig, views: Seq[VoxelView], worlds: Seq[VoxelWorld]): Unit =
    VoxelSession.compile(c, Blocks.assets).doSim("equal", seed) { dut =>
      val session = new VoxelSession(dut)
      for (world <- worlds) {
        val model = new VoxelModel(c, Blocks.assets, world)
        session.load(model.words)
        for ((view, n) <- views.zipWithIndex) {
          val camera = view.camera(c)
          val highlight = n % 2 == 0
          val pointedAt = model.pointedAt(camera, reach = 6)
          val pixels = for (j <- 0 until c.height; i <- 0 until c.width)
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
          val steps = pixels.map(_.steps).sum + picking
          assert(frame.steps == steps, s"$view")
          // Alone in the ring: the ray that picks, and at the end perhaps the longest.
          val alone = MarcherStages.Fast.slots * (picking + pixels.map(_.steps).max) + 100
          assert(frame.clocks <= steps / 0.98 + alone, s"$view: ${frame.clocks} clocks for $steps steps")
        }
      }
    }

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
    equal(c, VoxelViews(c, random, 12), Seq(0.05, 0.4).map(VoxelViews.scatter(c.size, random, _)))
  }

  test("hills at the size of the Arty's world") {
    val c = VoxelConfig(width = 64, height = 48)
    equal(c, VoxelViews(c, new Random(2), 8), Seq(Hills(c.size, 1)))
  }
}
