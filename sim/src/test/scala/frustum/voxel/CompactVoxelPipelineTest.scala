package frustum.voxel

import frustum.contract.voxel.{LeapField, VoxelConfig, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.engine.voxel.CompactVoxelSession
import frustum.harness.Simulated
import frustum.model.voxel.VoxelModel
import frustum.scene.{Hills, VoxelWorld}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import scala.util.Random

/** Pictures of the small voxel pipeline against the model of the large one, every pixel. */
class CompactVoxelPipelineTest extends AnyFunSuite with Simulated {
  private val seed = 1

  private def equal(c: VoxelConfig, frames: Int, worlds: Seq[VoxelWorld]): Unit =
    CompactVoxelSession.compile(c, Blocks.assets).doSim("equal", seed) { dut =>
      val random = new Random(seed)
      val session = new CompactVoxelSession(dut)
      for (world <- worlds) {
        val model = new VoxelModel(c, Blocks.assets, world)
        session.load(model.words)
        for ((view, n) <- VoxelViews(c, random, frames).zipWithIndex) {
          val camera = view.camera(c)
          val highlight = n % 2 == 0
          val pointedAt = model.pointedAt(camera, VoxelConfig.Reach)
          val pixels = for (j <- 0 until c.height; i <- 0 until c.width)
            yield model.pixel(camera, i, j, pointedAt.filter(_ => highlight))
          val pace = Seq(0, 15, 31)(n % 3)
          val frame = session.frame(camera, highlight, pace, stalls = n % 4 != 0)
          val wrong = pixels.indices.filter(i => CompactVoxelSession.shown(pixels(i).color) != frame.picture(i))
          wrong.headOption.foreach { i =>
            fail(
              f"seed $seed, $view: ${wrong.length} pixels wrong, the first is $i: ${frame.picture(i)}%06x, " +
                f"should be ${CompactVoxelSession.shown(pixels(i).color)}%06x of ${pixels(i)}"
            )
          }
          assert(session.pointedAt == pointedAt.map(f => (Seq(f.x, f.y, f.z), f.face)), s"$view")
          val steps = pixels.map(_.steps).sum + model.pointedAtSteps(camera)
          assert(frame.steps == steps, s"$view")
          info(
            f"pace $pace: ${frame.clocks.toDouble / c.pixels}%.2f clocks a pixel, ${steps.toDouble / c.pixels}%.2f " +
              f"steps, ${pixels.map(_.seen.size).sum.toDouble / c.pixels}%.2f faces"
          )
        }
      }
    }

  for (
    c <- Seq(
      VoxelConfig(size = WorldSize(16, 8, 16), width = 40, height = 32),
      VoxelConfig(
        size = WorldSize(16, 32, 8),
        width = 17,
        height = 19,
        leaps = LeapField.Chebyshev,
        distance = 12,
        fog = false,
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

  test(
    "what changes while a frame is drawn is seen in the next one; a world being loaded is not kept waiting"
  ) {
    val c = VoxelConfig(size = WorldSize(16, 8, 16), width = 40, height = 32)
    val random = new Random(seed)
    CompactVoxelSession.compile(c, Blocks.assets).doSim("changes", seed) { dut =>
      val session = new CompactVoxelSession(dut)
      var world = VoxelViews.scatter(c.size, random, 0.1)
      var words = new VoxelModel(c, Blocks.assets, world).words
      session.load(words)
      val cameras = VoxelViews(c, random, 40).map(_.camera(c))
      session.camera(cameras.head)
      for ((camera, next) <- cameras.zip(cameras.tail)) {
        val model = new VoxelModel(c, Blocks.assets, world)
        val expected = for (j <- 0 until c.height; i <- 0 until c.width) yield model.pixel(camera, i, j)
        session.start(highlight = false)
        // A camera that is not committed, two that are, and edits, all while the frame is drawn.
        session.camera(cameras.last, commit = false)
        session.camera(cameras.last)
        val (x, y, z) = (random.nextInt(16), random.nextInt(8), random.nextInt(16))
        val changed = world.updated(x, y, z, if (world(x, y, z) == 0) 1 + random.nextInt(24) else 0)
        val after = new VoxelModel(c, Blocks.assets, changed).words
        val edits = words.indices.filter(i => words(i) != after(i))
        if (edits.length < CompactVoxelPipeline.Patient) {
          edits.foreach(i => session.edit(i, after(i)))
          world = changed
          words = after
        }
        session.camera(next)
        session.camera(cameras.last, commit = false)
        assert(dut.io.busy.toBoolean)
        val frame = session.finish()
        val wrong =
          expected.indices.filter(i => CompactVoxelSession.shown(expected(i).color) != frame.picture(i))
        assert(wrong.isEmpty, s"seed $seed, $camera")
      }
      // More edits than can wait, in one frame: all are there at its end.
      val loaded = new VoxelModel(c, Blocks.assets, VoxelViews.scatter(c.size, random, 0.1))
      session.start(highlight = false)
      loaded.words.indices.foreach(i => session.edit(i, loaded.words(i)))
      session.finish()
      val frame = session.frame(cameras.head, highlight = false)
      val wrong = for (j <- 0 until c.height; i <- 0 until c.width; n = j * c.width + i)
        yield CompactVoxelSession.shown(loaded.pixel(cameras.head, i, j).color) != frame.picture(n)
      assert(!wrong.contains(true))
    }
  }
}
