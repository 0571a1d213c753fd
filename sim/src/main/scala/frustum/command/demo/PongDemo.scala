package frustum.command.demo

import frustum.command.pong.PongRecording.PongEntry
import frustum.command.pong.{PongRecording, PongReport, PongScenes}
import frustum.contract.video.VideoMode
import frustum.judge.PongJudge
import frustum.model.demos.pong.PongModel
import frustum.picture.Picture
import frustum.play.AutoPlayer
import java.nio.file.Path

/** Pong as a scene of `demo`: its first frames as `pong.gif`, the last of them beside the reference. */
object PongDemo {
  private val Frames = 16

  /** The report, and the exit code. */
  def apply(out: Path, seed: Long, entry: PongEntry): (ujson.Obj, Int) = {
    val config = PongScenes.config(VideoMode.Vga640x480, None)
    import config.mode.{height, width}
    val recording = PongRecording(config, AutoPlayer(_), seed, Frames, out.resolve("pong.gif"), entry = entry) {
      (index, game, picture) =>
        if (index == Frames - 1) {
          // The reference too in the format of the pins and under the score: what differs then is what was drawn
          // wrongly.
          val exact = PongJudge.reference(config, config.motion(game.motion))
          val reference = Picture.ofFormat(new PongModel(config).atPins(exact, game), config.format)
          DemoPictures.write(out, "pong", width, height, picture, reference)
        }
    }
    val report = PongReport.json("demo", seed, config, recording)
    (report, PongReport.write(out.resolve("pong.json"), report, recording))
  }
}
