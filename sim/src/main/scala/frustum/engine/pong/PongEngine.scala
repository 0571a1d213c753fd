package frustum.engine.pong

import frustum.demos.pong.{PongPipelineConfig, PongRules}
import frustum.engine.{Engine, EngineEntry, EngineKind, EngineSim, EngineTable}
import frustum.model.demos.pong.{HeldButtons, PongButtons, PongGame, PongModel}
import frustum.peripheral.VideoMeasure

/** What an engine of pong is built from.
  *
  * @param seed of whatever is random at the start of a simulation
  */
final case class PongSetting(config: PongPipelineConfig, board: PongBoard, seed: Long)

/** What was measured at the pins and inside since the start. */
final case class PongMeasures(
    frames: Long,
    clocksPerFrame: Long,
    pixelsPerClock: Double,
    latencyClocks: Int,
    syncErrors: Long,
    sync: Seq[VideoMeasure]
)

/** A frame as it was at the pins, counted from 0.
  *
  * @param measures of engines with pins
  */
final case class PongFrame(index: Int, atPins: Array[Int], score: Int, win: Boolean, measures: Option[PongMeasures])

/** The engines of pong. Works are the buttons that are held while a frame is shown: a tick's for an odd frame and the
  * next.
  */
object PongEngines
    extends EngineTable(
      new EngineEntry[PongSetting, Engine[PongButtons, PongFrame]](
        "hardware",
        EngineKind.Board
      )(new PongBoardEngine(_)),
      new EngineEntry[PongSetting, Engine[PongButtons, PongFrame]]("model", EngineKind.Model)(new PongModelEngine(_))
    )

/** A board's top in simulation, with a monitor and buttons at its pins. */
private final class PongBoardEngine(setting: PongSetting) extends Engine[PongButtons, PongFrame] {
  import setting.{board, config, seed}

  def draw(works: Iterator[PongButtons])(each: PongFrame => Unit): Unit = {
    val held = works.buffered
    if (held.hasNext) EngineSim.run(PongSession.compile(config, board), None, seed) { dut =>
      val session = new PongSession(dut, held.head)
      for ((buttons, index) <- held.zipWithIndex) {
        session.press(buttons)
        val atPins = session.frame()
        each(PongFrame(index, atPins, dut.score, dut.won, Some(measures(dut, session))))
      }
    }
  }

  private def measures(dut: PongTestbed, session: PongSession): PongMeasures = {
    val (reader, sync) = (session.reader, session.reader.measures)
    PongMeasures(
      reader.frames,
      reader.clocksPerFrame,
      config.mode.width.toDouble / sync.find(_.name == "width").get.last,
      dut.latencyClocks,
      reader.errors,
      sync
    )
  }
}

/** The bit-exact model of the same: ticks come in the blanks before odd frames. */
private final class PongModelEngine(setting: PongSetting) extends Engine[PongButtons, PongFrame] {
  def draw(works: Iterator[PongButtons])(each: PongFrame => Unit): Unit = {
    val held = works.buffered
    val model = new PongModel(setting.config)
    val buttons = new HeldButtons
    var game = PongGame.start
    var atPins = Array.empty[Int]
    // The first are pressed from power-up on, while the monitor still waits for a whole frame.
    if (held.hasNext) for (_ <- 0 to 1) buttons.look(held.head)
    var before = PongButtons()
    for ((pressed, index) <- held.zipWithIndex) {
      if (index == 0) atPins = model.frame(game)
      else {
        val accepted = buttons.look(before)
        if (index % PongRules.FramesPerTick == 1) {
          game = game.tick(accepted)
          atPins = model.frame(game)
        }
      }
      before = pressed
      each(PongFrame(index, atPins, game.score, game.won, None))
    }
  }
}
