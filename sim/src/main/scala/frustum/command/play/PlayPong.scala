package frustum.command.play

import frustum.command.pong.PongScenes
import frustum.contract.video.VideoMode
import frustum.demos.pong.PongPipelineConfig
import frustum.engine.EngineKind
import frustum.engine.pong.{PongBoard, PongEngines, PongFrame, PongSession, PongSetting}
import frustum.picture.Picture
import frustum.play.{LiveScreen, Pace, PlayScreen, PongKeys}

/** `play pong`: the simulated board as fast as it goes, or its model in real time. */
object PlayPong {
  val Engines: Seq[String] = PongEngines.names

  def apply(o: PlayOptions): Int = {
    val entry = o.engineOf(PongEngines, Engines)
    val config = PongScenes.config(o.mode, None)
    LiveScreen.require()
    println(PongKeys.help)
    val board = PongBoard.Icebreaker
    if (entry.kind.simulated) PongSession.compile(config, board) // before the window opens, and not in the rate
    val screen = LiveScreen("Frustum: pong", o.mode.width, o.mode.height)
    try {
      val pace = Option.when(entry.kind == EngineKind.Model)(new Pace(rate(o.mode)))
      val started = System.nanoTime
      val last = play(config, screen, o.frames, pace) { buttons => each =>
        entry.make(PongSetting(config, board, o.seed)).draw(buttons)(each)
      }
      println(PlayCommand.summaryOf(last.fold(0)(_.index + 1), started, s"score ${last.fold(0)(_.score)}"))
      val errors = last.flatMap(_.measures).fold(0L)(_.syncErrors)
      if (errors > 0) Console.err.println(s"error: play pong: $errors sync errors; ./sbt \"pong\" tells which")
      if (errors > 0) 1 else 0
    } finally screen.close()
  }

  /** The game itself, whatever draws it and wherever it is shown; gives the last frame.
    *
    * @param frames ends after so many; None: when the screen is closed
    * @param pace   None: as fast as it goes
    * @param draw   of an engine
    */
  private[play] def play(config: PongPipelineConfig, screen: PlayScreen, frames: Option[Int], pace: Option[Pace])(
      draw: Iterator[frustum.model.demos.pong.PongButtons] => (PongFrame => Unit) => Unit
  ): Option[PongFrame] = {
    val keys = new PongKeys
    var last = Option.empty[PongFrame]
    var picture = Array.empty[Int]
    def goesOn = screen.isOpen && frames.forall(last.fold(0)(_.index + 1) < _)
    val pressed = Iterator.continually(()).takeWhile(_ => goesOn).map(_ => keys(screen.keys()))
    draw(pressed) { frame =>
      if (!last.exists(_.atPins eq frame.atPins)) picture = Picture.ofFormat(frame.atPins, config.format)
      last = Some(frame)
      pace.foreach(_.await())
      screen.show(picture, state(screen.framesPerSecond, frame, config.mode))
    }
    last
  }

  /** Frames a second of a monitor. */
  private[play] def rate(mode: VideoMode): Double = mode.pixelMHz * 1e6 / (mode.hTotal.toDouble * mode.vTotal)

  private def state(perSecond: Double, frame: PongFrame, mode: VideoMode) =
    f"${100 * perSecond / rate(mode)}%.0f %% of the board's speed - score ${frame.score}"
}
