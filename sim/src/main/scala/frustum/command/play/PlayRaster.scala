package frustum.command.play

import frustum.command.render.RenderCommand
import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.engine.EngineKind
import frustum.engine.raster.{EngineOptions, PinsEngine, PipelineEngine, RasterEngines, RenderedFrame}
import frustum.files.Notices
import frustum.picture.Picture
import frustum.play.{LiveScreen, PlayScreen, RasterView}
import frustum.scene.ObjScene

/** `play raster`: a mesh to turn, to zoom and to light, drawn by any engine. */
object PlayRaster {
  val Engines: Seq[String] = Seq("model", "pipeline", "hardware", "reference")
  private val Size = (240, 320)

  /** A window is at least so high. */
  private val WindowHeight = 480

  def apply(o: PlayOptions): Int = {
    val entry = o.engineOf(RasterEngines, Engines)
    val (width, height) = o.size.getOrElse(Size)
    val config = RenderCommand.configOf(width, height)
    val aspect = width.toDouble / height
    val scene = RenderCommand.sceneOf(o.scene, o.obj, ObjScene.Options(None, None, config.textureTexels, aspect))
    val start = RasterView(scene, aspect)
    prepared(start, config, 0) // refuses what cannot be drawn
    Notices.print(scene.notices)
    LiveScreen.require()
    println(RasterView.help)
    // Before the window opens, and not in the rate.
    if (entry.kind == EngineKind.Board) PinsEngine.compile(config, Panel.Ili9341)
    if (entry.kind == EngineKind.Pipeline) PipelineEngine.compile(config)
    val scale = ((WindowHeight + height - 1) / height).max(1)
    val screen = LiveScreen(s"Frustum: ${scene.name}, engine ${entry.name}", width, height, scale)
    try {
      val started = System.nanoTime
      val shown = play(start, config, screen, o.frames) { frames => each =>
        entry.make(EngineOptions(o.seed, None, live = true)).draw(frames)(each)
      }
      println(PlayCommand.summaryOf(shown, started, s"engine ${entry.name}"))
      0
    } finally screen.close()
  }

  /** View after view, whatever draws them and wherever they are shown; gives their number. A view that cannot be drawn
    * is
    * told in the title, and the one before stays.
    *
    * @param frames ends after so many; None: when the screen is closed
    * @param draw   of an engine that takes each frame when the one before is shown
    */
  private[play] def play(start: RasterView, config: RasterConfig, screen: PlayScreen, frames: Option[Int])(
      draw: Iterator[PreparedFrame] => (RenderedFrame => Unit) => Unit
  ): Int = {
    var (shown, view, refused) = (0, start, "")
    val works = Iterator.continually(()).takeWhile(_ => screen.isOpen && frames.forall(shown < _)).map { _ =>
      val next = view.next(screen.keys(), screen.pointer())
      try {
        val frame = prepared(next, config, shown)
        view = next
        refused = ""
        frame
      } catch {
        case InputError(message) =>
          refused = s"not drawn: $message"
          view = view.copy(held = next.held)
          prepared(view, config, shown)
      }
    }
    draw(works) { drawn =>
      screen.show(Picture.ofRgb565(drawn.image), if (refused.isEmpty) view.state else refused)
      shown += 1
    }
    shown
  }

  private def prepared(view: RasterView, config: RasterConfig, frame: Int): PreparedFrame =
    Driver.prepare(view.scene, view.camera(config.width.toDouble / config.height), view.options, config, frame & 0xffff)
}
