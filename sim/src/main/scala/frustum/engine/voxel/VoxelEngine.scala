package frustum.engine.voxel

import frustum.contract.voxel.{VoxelAssets, VoxelConfig}
import frustum.driver.voxel.VoxelView
import frustum.engine.Engine
import frustum.model.voxel.{VoxelModel, VoxelPixel}
import frustum.scene.VoxelWorld

/** What an engine of blocks draws.
  *
  * @param highlight the face in the middle of the picture, if within reach
  * @param seed of whatever is random at the start of a simulation
  */
final case class VoxelSetting(
    config: VoxelConfig,
    assets: VoxelAssets,
    world: VoxelWorld,
    highlight: Boolean,
    seed: Long
) {
  lazy val model = new VoxelModel(config, assets, world)

  /** The model's pixels of a view, row by row. */
  def pixels(view: VoxelView): IndexedSeq[VoxelPixel] = {
    val camera = view.camera(config)
    val chosen = if (highlight) model.pointedAt(camera, VoxelConfig.Reach) else None
    for (j <- 0 until config.height; i <- 0 until config.width) yield model.pixel(camera, i, j, chosen)
  }
}

/** A view as an engine drew it.
  *
  * @param pictures every picture of the view that the engine put out, 0xRRGGBB row by row; all must be the same view
  * @param cycles of the pipeline, from start to last pixel
  * @param cyclesAtPins as `cycles`, with a display that takes its time
  */
final case class RenderedView(
    pictures: Seq[Array[Int]],
    cycles: Option[Long] = None,
    cyclesAtPins: Option[Long] = None
) {
  def picture: Array[Int] = pictures.head
}

/** Draws views of a world of blocks. */
trait VoxelEngine extends Engine[VoxelView, RenderedView] {

  /** The pictures of a view as the engine puts them out where each pixel is right.
    *
    * @param model the model's picture, 0xRRGGBB
    */
  def expected(model: Array[Int]): Seq[Array[Int]] = Seq(model)
}
