package frustum.voxel

import frustum.engine.SmallVoxelSession
import frustum.model.pipelines.VoxelModel
import frustum.scene.{Hills, VoxelWorld}
import frustum.spec.{Blocks, LeapField, VoxelConfig, WorldSize}
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** Pictures of the small voxel pipeline against the model of the large one, every pixel. */
class SmallVoxelPipelineTest extends AnyFunSuite {
  private val seed = 1

  private def equal(c: VoxelConfig, frames: Int, worlds: Seq[VoxelWorld]): Unit =
    SmallVoxelSession.compile(c, Blocks.assets).doSim("equal", seed) { dut =>
      val random  = new Random(seed)
      val session = new SmallVoxelSession(dut)
      for (world <- worlds) {
        val model = new VoxelModel(c, Blocks.assets, world)
        session.load(model.words)
        for ((view, n) <- VoxelViews(c, random, frames).zipWithIndex) {
          val camera    = view.camera(c)
          val highlight = n % 2 == 0
          val pointedAt = model.pointedAt(camera, VoxelConfig.Reach)
          val pixels    = for (j <- 0 until c.height; i <- 0 until c.width)
            yield model.pixel(camera, i, j, pointedAt.filter(_ => highlight))
          val pace  = Seq(0, 15, 31)(n % 3)
          val frame = session.frame(camera, highlight, pace, stalls = n % 4 != 0)
          val wrong = pixels.indices.filter(i => SmallVoxelSession.shown(pixels(i).color) != frame.picture(i))
          wrong.headOption.foreach { i =>
            fail(
              f"seed $seed, $view: ${wrong.length} pixels wrong, the first is $i: ${frame.picture(i)}%06x, " +
                f"should be ${SmallVoxelSession.shown(pixels(i).color)}%06x of ${pixels(i)}"
            )
          }
          assert(session.pointedAt == pointedAt.map(f => (Seq(f.x, f.y, f.z), f.face)), s"$view")
          val steps = pixels.map(_.steps).sum + model.pointedAtSteps(camera)
          assert(frame.steps == steps, s"$view")
          info(f"pace $pace: ${frame.clocks.toDouble / c.pixels}%.2f clocks a pixel, ${steps.toDouble / c.pixels}%.2f steps, ${pixels.map(_.seen.size).sum.toDouble / c.pixels}%.2f faces")
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
        leaps = LeapField.Chebyshev,
        distance = 12,
        fog = false
      ),
      VoxelConfig(
        size = WorldSize(16, 16, 32),
        width = 17,
        height = 19,
        leaps = LeapField.Plain,
        slopeBits = 13,
        eyeBits = 5
      )
    )
  ) test(s"pictures and steps are the model's, $c") {
    val random = new Random(seed)
    equal(c, 12, Seq(0.05, 0.4).map(VoxelViews.scatter(c.size, random, _)))
  }

  test("hills at the size of the iCE40's world") {
    val c = VoxelConfig(width = 64, height = 48)
    equal(c, 9, Seq(Hills(c.size, 1)))
  }
}
