package frustum.command.pong

import frustum.command.common.Progress
import frustum.demos.pong.PongPipelineConfig
import frustum.engine.{Engine, EngineEntry}
import frustum.engine.pong.{PongBoard, PongEngines, PongFrame, PongSetting}
import frustum.judge.{PongFigures, PongJudge}
import frustum.model.demos.pong.{PongButtons, PongGame}
import frustum.picture.{AnimatedGif, Picture}
import frustum.play.PlayedGame
import java.nio.file.Path

/** A game on an engine: its last frame, with what was measured until then, and what the judge found. */
final case class PongRecording(
    engine: PongRecording.PongEntry,
    last: PongFrame,
    figures: PongFigures,
    judged: Int,
    seconds: Double
)

object PongRecording {
  type PongEntry = EngineEntry[PongSetting, Engine[PongButtons, PongFrame]]

  /** A tick is two frames, a thirtieth of a second: hundredths that add up to it. */
  private def delays: Iterator[Int] = Iterator.continually(Seq(3, 3, 4)).flatten

  /** Plays, judges frames and writes one a tick to `gif`.
    *
    * @param every one frame of so many is judged, filmed and given to `each`
    * @param each takes a frame's number, the state that it shows, and its picture as 0xRRGGBB
    */
  def apply(
      config: PongPipelineConfig,
      player: PongGame => PongButtons,
      seed: Long,
      frames: Int,
      gif: Path,
      board: PongBoard = PongBoard.all.head,
      every: Int = 1,
      entry: PongEntry = PongEngines.default
  )(each: (Int, PongGame, Array[Int]) => Unit): PongRecording = {
    val judge = new PongJudge(config)
    val times = delays
    val started = System.nanoTime
    val progress = Progress("pong", frames)
    val (shown, played) = PlayedGame.frames(player).take(frames).duplicate
    var last = Option.empty[PongFrame]
    try AnimatedGif.write(gif, config.mode.width, config.mode.height) { film =>
        entry.make(PongSetting(config, board, seed)).draw(played.map(_._2)) { frame =>
          val (index, game) = (frame.index, shown.next()._1)
          if (index % every == 0) {
            val picture = Picture.ofFormat(frame.atPins, config.format)
            each(index, game, picture)
            if (every > 1 || index % 2 == 0) film.add(picture, times.next())
            judge.add(game, frame.atPins)
          }
          last = Some(frame)
          progress.step()
        }
      }
    finally progress.close()
    PongRecording(entry, last.get, judge.figures(), (frames + every - 1) / every, (System.nanoTime - started) / 1e9)
  }
}
