package frustum.engine

import frustum.host.VoxelView
import frustum.judge.{Psnr, VoxelCounts, VoxelJudge}
import frustum.model.pipelines.VoxelModel
import frustum.reference.voxel.IdealVoxelPicture
import frustum.scene.VoxelWorld
import frustum.spec.{Blocks, VoxelAssets, VoxelCamera, VoxelConfig}

/** A view as it was drawn: the engine's picture, the ideal one, and what was found. Pictures are 0xRRGGBB row by row.
  *
  * @param counts of the model's rays; none where nothing but the reference was drawn
  * @param clocks with the hardware alone
  * @param pixelsDifferent of the hardware from the model
  * @param clocksAtPins as clocks, with a display that takes its time; of the small pipeline
  */
final case class VoxelDrawn(
    picture: Array[Int],
    reference: Array[Int],
    counts: Option[VoxelCounts],
    clocks: Option[Long],
    pixelsDifferent: Option[Long],
    clocksAtPins: Option[Long] = None
) {
  def squaredError: Double = Psnr.squaredError(picture, reference)
}

/** Draws views of a world: `hardware` is the large pipeline, `small` the one for the iCE40.
  *
  * @param highlight the face in the middle of the screen
  */
final class VoxelRun(
    config: VoxelConfig,
    assets: VoxelAssets,
    world: VoxelWorld,
    engine: String,
    highlight: Boolean,
    seed: Long
) {
  private lazy val model = new VoxelModel(config, assets, world)
  private lazy val judge = new VoxelJudge(model)

  def draw(views: Seq[VoxelView])(each: VoxelDrawn => Unit): Unit = engine match {
    case "hardware" =>
      EngineSim.run(VoxelSession.compile(config, assets), None, seed) { dut =>
        val session = new VoxelSession(dut)
        session.load(model.words)
        for (view <- views) each(drawn(view, Some(session.frame(_, highlight))))
      }
    case "small" =>
      EngineSim.run(SmallVoxelSession.compile(config, assets), None, seed) { dut =>
        val session = new SmallVoxelSession(dut)
        session.load(model.words)
        for (view <- views) {
          val fast = drawn(view, Some(session.frame(_, highlight)), SmallVoxelSession.shown)
          val slow = session.frame(view.camera(config), highlight, pace = SmallVoxelSession.DisplayPace)
          val same = slow.picture.sameElements(fast.picture)
          each(fast.copy(
            clocksAtPins = Some(slow.clocks),
            pixelsDifferent = fast.pixelsDifferent.map(_ + (if (same) 0 else config.pixels))
          ))
        }
      }
    case _ => for (view <- views) each(drawn(view, None))
  }

  /** @param shown what the hardware's picture has of a colour */
  private def drawn(
      view: VoxelView,
      hardware: Option[VoxelCamera => VoxelFrame],
      shown: Int => Int = identity
  ): VoxelDrawn = {
    val ideal = new IdealVoxelPicture(config, assets, world, view).picture()
    if (engine == "reference") VoxelDrawn(ideal, ideal, None, None, None)
    else {
      val camera = view.camera(config)
      val chosen = if (highlight) model.pointedAt(camera, VoxelConfig.Reach) else None
      val pixels =
        for (j <- 0 until config.height; i <- 0 until config.width) yield model.pixel(camera, i, j, chosen)
      val colors  = pixels.map(p => shown(p.color)).toArray
      val frame   = hardware.map(_(camera))
      val differs = frame.map(f => colors.indices.count(i => colors(i) != f.picture(i)).toLong)
      VoxelDrawn(
        frame.fold(colors)(_.picture),
        ideal,
        Some(judge.picture(camera, view, pixels)),
        frame.map(_.clocks),
        differs
      )
    }
  }
}

object VoxelRun {
  val Engines = Seq("hardware", "small", "model", "reference")
}
