package frustum.engine.voxel

import frustum.contract.voxel.LeapField
import frustum.driver.voxel.VoxelView
import frustum.engine.EngineKind._
import frustum.engine.{EngineEntry, EngineKind, EngineSim, EngineTable}
import frustum.reference.voxel.IdealVoxelPicture

/** The engines of blocks. */
object VoxelEngines
    extends EngineTable(
      new VoxelEngineEntry("hardware", Board)(new VoxelBoardEngine(_)),
      new VoxelEngineEntry("pipeline", Pipeline)(new WideVoxelEngine(_)),
      new VoxelEngineEntry("compact", Pipeline, "icebreaker-voxel", LeapField.UpDown, Some("small"))(
        new CompactVoxelEngine(_)
      ),
      new VoxelEngineEntry("model", Model)(setting =>
        new StillVoxelEngine(view => setting.pixels(view).map(_.color).toArray)
      ),
      new VoxelEngineEntry("reference", Reference)(setting =>
        new StillVoxelEngine(view =>
          IdealVoxelPicture(setting.config, setting.assets, setting.world, view).picture()
        )
      )
    )

/** An engine of blocks by name.
  *
  * @param top whose clock frequency the figures per second are of
  * @param leaps of the top's world
  */
final class VoxelEngineEntry(
    name: String,
    kind: EngineKind,
    val top: String = "arty-voxel",
    val leaps: LeapField = LeapField.Quadrants,
    former: Option[String] = None
)(make: VoxelSetting => VoxelEngine)
    extends EngineEntry[VoxelSetting, VoxelEngine](name, kind, former)(make)

/** An engine that is a picture of a view. */
private final class StillVoxelEngine(picture: VoxelView => Array[Int]) extends VoxelEngine {
  def draw(views: Iterator[VoxelView])(each: RenderedView => Unit): Unit =
    views.foreach(view => each(RenderedView(Seq(picture(view)))))
}

/** The wide pipeline in simulation. */
private final class WideVoxelEngine(setting: VoxelSetting) extends VoxelEngine {
  import setting.{assets, config, highlight}

  def draw(views: Iterator[VoxelView])(each: RenderedView => Unit): Unit =
    EngineSim.run(VoxelSession.compile(config, assets), None, setting.seed) { dut =>
      val session = new VoxelSession(dut)
      session.load(setting.model.words)
      for (view <- views) {
        val frame = session.frame(view.camera(config), highlight)
        each(RenderedView(Seq(frame.picture), Some(frame.clocks)))
      }
    }
}
