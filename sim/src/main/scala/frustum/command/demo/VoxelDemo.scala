package frustum.command.demo

import frustum.command.voxel.{JudgedViews, ViewFigures, VoxelOptions, VoxelReport, VoxelScenes}
import frustum.driver.linear.Vector3
import frustum.engine.voxel.VoxelEngineEntry
import java.nio.file.Path

/** The world of blocks as a scene of `demo`: hills with a lake. */
object VoxelDemo {
  def apply(out: Path, engine: VoxelEngineEntry): (ujson.Obj, Int) = {
    val o = VoxelOptions(
      engine = engine,
      eye = Some(Vector3(10, 40, 19)),
      yaw = Some(-40),
      pitch = Some(-15),
      distance = 50,
      seed = 2
    )
    val scene = VoxelScenes(o)
    import scene.config.{height, width}
    var drawn = Option.empty[ViewFigures]
    new JudgedViews(scene, engine, highlight = false, o.seed).draw { view =>
      DemoPictures.write(out, "voxel", width, height, view.picture, view.reference)
      drawn = Some(view.figures)
    }
    val report = VoxelReport.json("demo", o.seed, engine, scene.config, drawn.toSeq)
    (report, VoxelReport.write(out.resolve("voxel.json"), report, drawn.toSeq))
  }
}
