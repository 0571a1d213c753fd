package frustum.command.pong

import frustum.command.common.Progress
import frustum.demos.pong.PongPipelineConfig
import frustum.engine.pong.{PongBoard, PongFrame, PongMeasures, PongRun}
import frustum.judge.{PongFigures, PongJudge}
import frustum.model.demos.pong.{PongButtons, PongGame}
import frustum.picture.{AnimatedGif, Picture}
import java.nio.file.Path

/** A game on the simulated board: what was measured on it, and what the judge found. */
final case class PongRecording(measures: PongMeasures, figures: PongFigures, judged: Int, seconds: Double)

object PongRecording {

  /** A tick is two frames, a thirtieth of a second: hundredths that add up to it. */
  private def delays: Iterator[Int] = Iterator.continually(Seq(3, 3, 4)).flatten

  /** Plays, judges frames and writes one a tick to `gif`.
    *
    * @param every one frame of so many is judged, filmed and given to `each`
    * @param each takes a frame and its picture as 0xRRGGBB
    */
  def apply(
      config: PongPipelineConfig,
      player: PongGame => PongButtons,
      seed: Long,
      frames: Int,
      gif: Path,
      board: PongBoard = PongBoard.all.head,
      every: Int = 1
  )(each: (PongFrame, Array[Int]) => Unit): PongRecording = {
    val judge = new PongJudge(config)
    val times = delays
    val started = System.nanoTime
    val progress = Progress("pong", frames)
    val measures =
      try AnimatedGif.write(gif, config.mode.width, config.mode.height) { film =>
          new PongRun(config, player, seed, board).play(frames) { frame =>
            if (frame.index % every == 0) {
              val picture = Picture.ofFormat(frame.atPins, config.format)
              each(frame, picture)
              if (every > 1 || frame.index % 2 == 0) film.add(picture, times.next())
              judge.add(frame)
            }
            progress.step()
          }
        }
      finally progress.close()
    PongRecording(measures, judge.figures(), (frames + every - 1) / every, (System.nanoTime - started) / 1e9)
  }
}
