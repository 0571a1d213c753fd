package frustum.model.voxel

import frustum.contract.voxel.{SeenFace, VoxelAssets, VoxelCamera, VoxelConfig}
import frustum.model.voxel.march.{FaceHit, Marcher, RayAxes, RayStart}
import frustum.model.voxel.wide.{FaceTexel, LayerComposite, VoxelRaySetup}
import frustum.model.voxel.world.LeapWords
import frustum.scene.VoxelWorld

/** One ray: its start, what it saw front to back, its colour and how many words of memory it read. */
final case class VoxelPixel(ray: RayStart, seen: Seq[SeenFace], color: Int, steps: Int)

/** The voxel pipeline, bit for bit. */
final class VoxelModel(val config: VoxelConfig, val assets: VoxelAssets, val world: VoxelWorld) {
  require(world.size == config.size, s"a world of ${world.size} for hardware of ${config.size}")
  val words: Array[Int] = LeapWords(world, config.leaps)
  private val marcher = new Marcher(config, assets.table, words)

  /** @param pointedAt the block and face to be highlighted */
  def pixel(camera: VoxelCamera, i: Int, j: Int, pointedAt: Option[SeenFace] = None): VoxelPixel =
    cast(camera, camera.direction(i, j), pointedAt)

  /** The nearest face of a selectable block that the middle of the screen shows within `reach` blocks. */
  def pointedAt(camera: VoxelCamera, reach: Int): Option[SeenFace] = {
    val eye = camera.eye.axes
    var found = Option.empty[SeenFace]
    marcher.march(VoxelRaySetup(eye, camera.look.axes, config)) { hit =>
      val texel = FaceTexel(hit, eye, config)
      if (found.isEmpty && assets.table(hit.id).selectable && texel.farSquared <= 256 * reach * reach)
        found = Some(seen(hit, texel))
    }
    found
  }

  /** Steps of the ray that finds it. */
  def pointedAtSteps(camera: VoxelCamera): Int =
    marcher.march(VoxelRaySetup(camera.eye.axes, camera.look.axes, config))(_ => ())

  private def cast(camera: VoxelCamera, direction: Seq[Int], pointedAt: Option[SeenFace]): VoxelPixel = {
    val eye = camera.eye.axes
    val ray = VoxelRaySetup(eye, direction, config)
    val faces = Seq.newBuilder[SeenFace]
    var inView = true
    var layers = LayerComposite.Empty
    val steps = marcher.march(ray) { hit =>
      val texel = FaceTexel(hit, eye, config)
      inView &&= texel.farSquared <= config.farSquared
      if (inView) {
        val face = seen(hit, texel)
        val rgba = assets.textures(assets.table(hit.id).textures(texel.face), texel.u, texel.v)
        val chosen = pointedAt.exists(_.sameFace(face))
        layers =
          layers.behind(LayerComposite.face(rgba, texel.face, texel.farSquared, chosen, config), rgba & 15)
        faces += face
      }
    }
    VoxelPixel(ray, faces.result(), layers.behind(config.skyChannels, 15).color, steps)
  }

  private def seen(hit: FaceHit, t: FaceTexel): SeenFace = {
    val Seq(x, y, z) = (0 to 2).map(k => RayAxes.block(config, hit.ray.mirrored, hit.block(k), k))
    SeenFace(x, y, z, hit.id, t.face, t.u, t.v)
  }
}
