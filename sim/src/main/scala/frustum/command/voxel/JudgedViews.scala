package frustum.command.voxel

import frustum.driver.voxel.VoxelView
import frustum.engine.EngineKind
import frustum.engine.voxel.{RenderedView, VoxelEngineEntry, VoxelSetting}
import frustum.judge.{Psnr, VoxelCounts, VoxelJudge}
import frustum.reference.voxel.IdealVoxelPicture

/** A view as it was drawn, and what was found.
  *
  * @param reference the ideal picture with the engine's colours, 0xRRGGBB row by row
  * @param counts of the model's rays; none where the reference drew
  * @param pixelsDifferent of the hardware from the model
  */
final case class JudgedView(
    drawn: RenderedView,
    reference: Array[Int],
    counts: Option[VoxelCounts],
    pixelsDifferent: Option[Long]
) {
  def picture: Array[Int] = drawn.picture

  /** What is known of it, its pictures left behind. */
  def figures: ViewFigures =
    ViewFigures(drawn.cycles, drawn.cyclesAtPins, counts, pixelsDifferent, Psnr.squaredError(picture, reference))
}

/** The figures of a view, see [[JudgedView]] and [[frustum.engine.voxel.RenderedView]]. */
final case class ViewFigures(
    cycles: Option[Long],
    cyclesAtPins: Option[Long],
    counts: Option[VoxelCounts],
    pixelsDifferent: Option[Long],
    squaredError: Double
)

/** The views of a scene on their way through an engine and the judges. Refuses at once what the engine does not take.
  */
final class JudgedViews(scene: VoxelScene, entry: VoxelEngineEntry, highlight: Boolean, seed: Long) {
  import scene.{assets, config, views, world}
  private val setting = VoxelSetting(config, assets, world, highlight, seed)
  private val engine = entry.make(setting)
  private lazy val judge = new VoxelJudge(setting.model)

  def draw(each: JudgedView => Unit): Unit = {
    val judged = views.iterator
    engine.draw(views.iterator)(drawn => each(verdict(judged.next(), drawn)))
  }

  private def verdict(view: VoxelView, drawn: RenderedView): JudgedView =
    if (entry.kind == EngineKind.Reference) JudgedView(drawn, drawn.picture, None, None)
    else {
      val pixels = setting.pixels(view)
      val pairs = drawn.pictures.zip(engine.expected(pixels.map(_.color).toArray))
      val different = pixels.indices.count(n => pairs.exists { case (is, due) => is(n) != due(n) })
      JudgedView(
        drawn,
        // Of no more bits than the engine's colours have: what differs then is what was drawn.
        engine.expected(IdealVoxelPicture(config, assets, world, view).picture()).head,
        Some(judge.picture(view.camera(config), view, pixels)),
        Option.when(entry.kind.simulated)(different.toLong)
      )
    }
}
