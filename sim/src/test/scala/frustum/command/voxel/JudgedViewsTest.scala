package frustum.command.voxel

import frustum.driver.voxel.VoxelView
import frustum.engine.EngineKind
import frustum.engine.voxel.{RenderedView, VoxelEngine, VoxelEngineEntry, VoxelSetting}
import frustum.reference.voxel.IdealVoxelPicture
import org.scalatest.funsuite.AnyFunSuite

/** Pictures are compared with the reference in the engine's colours. */
class JudgedViewsTest extends AnyFunSuite {
  private def cut(rgb: Int) = rgb & 0xf0f0f0

  /** Draws the ideal picture with four bits a channel. */
  private final class Coarse(setting: VoxelSetting) extends VoxelEngine {
    import setting.{assets, config, world}
    override def expected(model: Array[Int]): Seq[Array[Int]] = Seq(model.map(cut))
    def draw(views: Iterator[VoxelView])(each: RenderedView => Unit): Unit =
      for (v <- views) each(RenderedView(expected(IdealVoxelPicture(config, assets, world, v).picture())))
  }

  test("what differs is never the number of bits of a colour") {
    val scene = VoxelScenes(VoxelOptions(size = (40, 30)))
    var judged = 0
    new JudgedViews(scene, new VoxelEngineEntry("coarse", EngineKind.Board)(new Coarse(_)), highlight = false, 1).draw {
      view =>
        assert(view.reference.forall(rgb => rgb == cut(rgb)) && view.figures.squaredError == 0)
        judged += 1
    }
    assert(judged == 1)
  }
}
