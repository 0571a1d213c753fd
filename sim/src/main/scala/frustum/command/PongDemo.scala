package frustum.command

import frustum.engine.{PongFrame, PongRun}
import frustum.game.AutoPlayer
import frustum.judge.PongJudge
import frustum.model.pipelines.PongModel
import frustum.picture.{AnimatedGif, Picture}
import frustum.spec.VideoMode
import java.nio.file.Path

/** Pong as a scene of `demo`: its first frames as `pong.gif`, the last of them beside the reference. */
object PongDemo {
  private val Frames = 16

  /** The report, and what is wrong. */
  def apply(out: Path, seed: Long): (ujson.Obj, Seq[String]) = {
    val config = PongScenes.config(VideoMode.Vga640x480, None)
    import config.mode.{height, width}
    val judge    = new PongJudge(config)
    val started  = System.nanoTime
    var last     = Option.empty[PongFrame]
    var measured = Option.empty[frustum.engine.PongMeasures]
    val progress = Progress("pong", Frames)
    try AnimatedGif.write(out.resolve("pong.gif"), width, height) { gif =>
        val times = PongCommand.delays
        measured = Some(new PongRun(config, AutoPlayer(_), seed).play(Frames) { frame =>
          judge.add(frame)
          if (frame.index % 2 == 0) gif.add(Picture.ofFormat(frame.atPins, config.format), times.next())
          last = Some(frame)
          progress.step()
        })
      }
    finally progress.close()
    val figures = judge.figures()

    // The reference too in the format of the pins and under the score: what differs then is what was drawn wrongly.
    val exact     = PongJudge.reference(config, last.get.game.motion)
    val reference = Picture.ofFormat(new PongModel(config).atPins(i => exact(i), last.get.game), config.format)
    val picture   = Picture.ofFormat(last.get.atPins, config.format)
    Picture.writePng(out.resolve("pong.png"), width, height, picture)
    Picture.writePng(out.resolve("pong.reference.png"), width, height, reference)
    Picture.writePng(out.resolve("pong.difference.png"), width, height, Picture.difference(picture, reference))
    (
      PongReport.json("demo", seed, config, measured.get, figures, (System.nanoTime - started) / 1e9),
      PongReport.failures(measured.get, figures)
    )
  }
}
