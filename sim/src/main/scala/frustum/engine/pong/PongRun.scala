package frustum.engine.pong

import frustum.demos.pong.PongPipelineConfig
import frustum.engine.EngineSim
import frustum.model.demos.pong.{PongButtons, PongGame}
import frustum.peripheral.VideoMeasure

/** A frame as it was at the pins, and the game's state by the model at the same time. */
final case class PongFrame(index: Int, atPins: Array[Int], game: PongGame)

/** What was measured on the hardware. */
final case class PongMeasures(
    frames: Long,
    clocksPerFrame: Long,
    pixelsPerClock: Double,
    latencyClocks: Int,
    syncErrors: Long,
    score: Int,
    win: Boolean,
    sync: Seq[VideoMeasure]
)

/** A game on the simulated hardware with the model's beside it, which tells the player where things are.
  *
  * @param player presses the buttons of the tick that follows a state; called once for each tick, in order
  */
final class PongRun(
    config: PongPipelineConfig,
    player: PongGame => PongButtons,
    seed: Long,
    board: PongBoard = PongBoard.Icebreaker
) {

  def play(frames: Int)(each: PongFrame => Unit): PongMeasures =
    EngineSim.run(PongSession.compile(config, board), None, seed) { dut =>
      var states = Vector(PongGame.start)
      def next() = { val b = player(states.last); states :+= states.last.tick(b); b }
      val session = new PongSession(dut, next())
      for (f <- 0 until frames) {
        val atPins = session.frame()
        if (f % 2 == 0) session.press(next())
        each(PongFrame(f, atPins, states((f + 1) / 2)))
      }
      val (reader, sync) = (session.reader, session.reader.measures)
      PongMeasures(
        reader.frames,
        reader.clocksPerFrame,
        config.mode.width.toDouble / sync.find(_.name == "width").get.last,
        dut.latencyClocks,
        reader.errors,
        dut.score,
        dut.won,
        sync
      )
    }
}
