package frustum.command

import frustum.engine.{VoxelDrawn, VoxelRun}
import frustum.picture.Picture
import org.joml.Vector3d
import java.nio.file.Path

/** The world of blocks as a scene of `demo`: hills with a lake. */
object VoxelDemo {

  /** @param engine one of [[VoxelRun.Engines]] */
  def apply(out: Path, engine: String): (ujson.Obj, Int) = {
    val o = VoxelOptions(
      engine = engine,
      eye = Some(new Vector3d(10, 40, 19)),
      yaw = -40,
      pitch = -15,
      distance = 50,
      seed = 2
    )
    val scene = VoxelScenes(o)
    import scene.config.{height, width}
    var drawn = Option.empty[VoxelDrawn]
    new VoxelRun(scene.config, scene.assets, scene.world, engine, highlight = false, o.seed)
      .draw(scene.views)(view => drawn = Some(view))
    for (
      (kind, picture) <- Seq(
        ""            -> drawn.get.picture,
        ".reference"  -> drawn.get.reference,
        ".difference" -> Picture.difference(drawn.get.picture, drawn.get.reference)
      )
    ) Picture.writePng(out.resolve(s"voxel$kind.png"), width, height, picture)
    val report = VoxelReport.json("demo", o.seed, engine, scene.config, drawn.toSeq)
    (report, VoxelReport.write(out.resolve("voxel.json"), report, drawn.toSeq))
  }
}
