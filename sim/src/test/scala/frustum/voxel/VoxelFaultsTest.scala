package frustum.voxel

import frustum.contract.voxel.{VoxelConfig, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.model.voxel.VoxelModel
import frustum.model.voxel.wide.LayerComposite
import frustum.scene.VoxelWorld
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** Faults that a renderer of this kind had once and that no other test names; what the model does here the hardware
  * does, see `VoxelPipelineTest`.
  */
class VoxelFaultsTest extends AnyFunSuite {
  private val c = VoxelConfig(size = WorldSize(8, 8, 8), width = 32, height = 24, fog = false)

  private def model(id: (Int, Int, Int) => Int) = new VoxelModel(c, Blocks.assets, VoxelWorld.tabulate(c.size)(id))
  private def ahead(x: Double) = VoxelView(Vector3(x, 3.5, 3.5), 0, 0, 20).camera(c)

  test("layers reach opaque, and what lies behind counts for what is left alone (seed 1)") {
    val random = new Random(1)
    for (_ <- 0 until 500) {
      val layers = Seq.fill(random.nextInt(12))((Seq.fill(3)(random.nextInt(256)), random.nextInt(15)))
      val last = (Seq.fill(3)(random.nextInt(256)), 15)
      val gathered = (layers :+ last).foldLeft(LayerComposite.Empty) { case (g, (rgb, a)) => g.behind(rgb, a) }
      val (want, _) = (layers :+ last).foldLeft((Seq(0.0, 0.0, 0.0), 1.0)) { case ((sum, left), (rgb, a)) =>
        val weight = left * (a + (a >> 3)) / 16.0
        (sum.zip(rgb).map { case (s, v) => s + weight * v }, left - weight)
      }
      assert(gathered.clear == 0)
      for ((got, w) <- VoxelConfig.channels(gathered.color).zip(want)) assert((got - w).abs <= 12, layers)
      // Behind an opaque layer nothing shows.
      assert(gathered.behind(Seq(255, 255, 255), 15) == gathered)
    }
  }

  test("one colour in any number of layers is that colour") {
    for (alpha <- 1 to 14; n <- 1 to 40) {
      val g = (Seq.fill(n)(alpha) :+ 15).foldLeft(LayerComposite.Empty)((sum, a) => sum.behind(Seq(200, 100, 50), a))
      assert(g.color == 0xc86432)
    }
  }

  test("a transparent block is selected before the opaque one behind it; water is not") {
    def seen(front: String) =
      model((x, _, _) => if (x == 4) Blocks.id(front) else if (x == 5) 1 else 0).pointedAt(ahead(1.5), 6).get
    assert(seen("glass").x == 4 && seen("leaves").x == 4 && seen("ice").x == 4)
    assert(seen("water").x == 5)
  }

  test("rays outside of the world see no block, wherever they go on; none is selected there") {
    val corner = model((x, y, z) => if (x == 0 && y == 0 && z == 0) 1 else 0)
    val full = model((_, _, _) => 1)
    for (eye <- Seq((-5.0, 3.5, 3.5), (3.5, 13.0, 3.5), (20.0, 20.0, -9.0), (3.5, 3.5, 30.0))) {
      val (x, y, z) = eye
      // Away from the middle of the world.
      val (yaw, pitch) = VoxelView.angles(Vector3(x - 4, y - 4, z - 4))
      val camera = VoxelView(Vector3(x, y, z), yaw, pitch, 20).camera(c)
      for (m <- Seq(corner, full)) {
        assert(
          (for (j <- 0 until c.height; i <- 0 until c.width) yield m.pixel(camera, i, j)).forall(_.seen.isEmpty),
          eye
        )
        assert(m.pointedAt(camera, 6).isEmpty)
      }
    }
  }

  test("hills as narrow as a world may be") {
    for (size <- Seq(WorldSize(4, 64, 32), WorldSize(64, 4, 32), WorldSize(4, 4, 4)))
      assert(frustum.scene.Hills(size, 1).size == size)
  }
}
