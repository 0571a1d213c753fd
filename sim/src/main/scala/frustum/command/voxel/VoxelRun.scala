package frustum.command.voxel

import frustum.contract.InputError
import frustum.contract.video.{ColorFormat, PinColor, VideoMode}
import frustum.contract.voxel.{VoxelAssets, VoxelCamera, VoxelConfig, VoxelHostCommand}
import frustum.demos.voxel.VoxelConsoleConfig
import frustum.driver.voxel.VoxelView
import frustum.engine.EngineSim
import frustum.engine.raster.Engines
import frustum.engine.voxel.{CompactVoxelSession, VoxelBoardSession, VoxelFrame, VoxelSession}
import frustum.judge.{Psnr, VoxelCounts, VoxelJudge}
import frustum.model.demos.voxel.VoxelScreen
import frustum.model.voxel.VoxelModel
import frustum.picture.Picture
import frustum.reference.voxel.IdealVoxelPicture
import frustum.scene.VoxelWorld

/** A view as it was drawn: the engine's picture, the ideal one, and what was found. Pictures are 0xRRGGBB row by row.
  *
  * @param counts of the model's rays; none where nothing but the reference was drawn
  * @param clocks of the pipeline, with the hardware alone
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

/** Draws views of a world: `pipeline` is the large pipeline alone, `small` the one for the iCE40.
  *
  * Pictures of the hardware, a board's top with a monitor at its pins, have the colours of the pins, of four bits a channel; it is held against the model's, cut
  * to these. All others have eight bits a channel.
  *
  * @param engine one of [[VoxelRun.Engines]]
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
  private lazy val board = VoxelRun.board(config, assets)
  private lazy val screen = VoxelScreen(board)

  def draw(views: Seq[VoxelView])(each: VoxelDrawn => Unit): Unit = engine match {
    case "hardware" =>
      EngineSim.run(VoxelBoardSession.compile(board), None, seed) { dut =>
        val session = new VoxelBoardSession(dut)
        session.load(model.words)
        for (view <- views) each(drawn(view, atPins(session, _, _)))
      }
    case "pipeline" =>
      EngineSim.run(VoxelSession.compile(config, assets), None, seed) { dut =>
        val session = new VoxelSession(dut)
        session.load(model.words)
        for (view <- views) each(drawn(view, direct(session.frame(_, highlight))))
      }
    case "small" =>
      EngineSim.run(CompactVoxelSession.compile(config, assets), None, seed) { dut =>
        val session = new CompactVoxelSession(dut)
        session.load(model.words)
        for (view <- views) {
          val fast = drawn(view, direct(session.frame(_, highlight), CompactVoxelSession.shown))
          val slow = session.frame(view.camera(config), highlight, pace = CompactVoxelSession.DisplayPace)
          val same = slow.picture.sameElements(fast.picture)
          each(fast.copy(
            clocksAtPins = Some(slow.clocks),
            pixelsDifferent = fast.pixelsDifferent.map(_ + (if (same) 0 else config.pixels))
          ))
        }
      }
    case "model" =>
      for (view <- views) each(drawn(view, (_, colors) => None -> colors))
    case _ =>
      for (view <- views) {
        val ideal = new IdealVoxelPicture(config, assets, world, VoxelJudge.rays(view, config)).picture()
        each(VoxelDrawn(ideal, ideal, None, None, None))
      }
  }

  private def atBoard(pins: Array[Int]) = Picture.ofFormat(pins, VoxelRun.color.format)

  /** @param colors the model's, in both of these */
  private def atPins(session: VoxelBoardSession, camera: VoxelCamera, colors: Array[Int]) = {
    session.send(if (highlight) VoxelHostCommand.highlight(camera) else VoxelHostCommand.camera(camera))
    val shown = session.settled()
    if (session.reader.errors > 0)
      throw new IllegalStateException(s"${session.reader.errors} sync errors at the monitor")
    val wanted = screen.monitor(colors.map(VoxelRun.color(_)), None)
    val places = Array.tabulate(config.pixels)(n =>
      ((n / config.width * config.width << board.scale) + n % config.width) << board.scale
    )
    def differs(at: Int) =
      (for (dy <- 0 until 1 << board.scale; dx <- 0 until 1 << board.scale) yield at + dy * board.mode.width + dx)
        .exists(i => shown(i) != wanted(i))
    Some(session.clocks -> places.count(differs).toLong) -> atBoard(places.map(shown(_)))
  }

  /** @param shown what the pipeline's picture has of a colour */
  private def direct(frame: VoxelCamera => VoxelFrame, shown: Int => Int = identity)(
      camera: VoxelCamera,
      colors: Array[Int]
  ) = {
    val f = frame(camera)
    Some(f.clocks -> colors.indices.count(i => shown(colors(i)) != f.picture(i)).toLong) -> f.picture
  }

  private def drawn(
      view: VoxelView,
      take: (VoxelCamera, Array[Int]) => (Option[(Long, Long)], Array[Int])
  ): VoxelDrawn = {
    val camera = view.camera(config)
    val chosen = if (highlight) model.pointedAt(camera, VoxelConfig.Reach) else None
    val pixels =
      for (j <- 0 until config.height; i <- 0 until config.width) yield model.pixel(camera, i, j, chosen)
    val (measured, picture) = take(camera, pixels.map(_.color).toArray)
    VoxelDrawn(
      picture,
      new IdealVoxelPicture(config, assets, world, VoxelJudge.rays(view, config)).picture(),
      Some(judge.picture(camera, view, pixels)),
      measured.map(_._1),
      measured.map(_._2)
    )
  }
}

object VoxelRun {
  val Engines = Seq("hardware", "pipeline", "small", "model", "reference")

  /** Of a board's pins. */
  val color: PinColor = PinColor(ColorFormat.Rgb444)

  /** The Arty's console for pictures of any size: its monitor has twice as many pixels each way. */
  def board(c: VoxelConfig, assets: VoxelAssets): VoxelConsoleConfig = {
    val vga = VideoMode.Vga640x480
    val mode = vga.copy(name = s"${2 * c.width}x${2 * c.height}", width = 2 * c.width, height = 2 * c.height)
    if (c.pixels % 8 != 0 || c.width < 48) throw InputError(
      s"--size ${c.width}x${c.height}: a board's monitor takes pictures at least 48 wide, of a multiple of 8 pixels; " +
        "change it or take --engine pipeline"
    )
    VoxelConsoleConfig(
      c,
      assets,
      if (mode.width == vga.width && mode.height == vga.height) vga else mode
    ).copy(color = color)
  }
}
