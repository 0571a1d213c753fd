package frustum.command

import frustum.BuildInfo
import frustum.engine.PongMeasures
import frustum.judge.PongFigures
import frustum.pipelines.PongPipelineConfig

/** The JSON report of `pong`, and of pong in `demo`. */
object PongReport {
  def json(command: String, seed: Long, c: PongPipelineConfig, m: PongMeasures, f: PongFigures, seconds: Double): ujson.Obj =
    ujson.Obj(
      "command"               -> command,
      "version"               -> BuildInfo.version,
      "seed"                  -> seed.toDouble,
      "engine"                -> "hardware",
      "scene"                 -> "pong",
      "mode"                  -> c.mode.name,
      "width"                 -> c.mode.width,
      "height"                -> c.mode.height,
      "format"                -> c.format.name,
      "frames"                -> m.frames.toDouble,
      "clocksPerFrame"        -> m.clocksPerFrame.toDouble,
      "pixelsPerClock"        -> m.pixelsPerClock,
      "latencyClocks"         -> m.latencyClocks,
      "syncErrors"            -> m.syncErrors.toDouble,
      "silhouettePixelsWrong" -> f.silhouettePixelsWrong.toDouble,
      "shadowPixelsWrong"     -> f.shadowPixelsWrong.toDouble,
      "objectPixelsWrong"     -> f.objectPixelsWrong.toDouble,
      "checkerCellsWrong"     -> f.checkerCellsWrong.toDouble,
      "maxColourError"        -> f.maxColourError,
      "colourErrorsOver1"     -> f.colourErrorsOver1.toDouble,
      "psnr"                  -> f.psnr.fold[ujson.Value](ujson.Null)(ujson.Num(_)),
      "score"                 -> m.score,
      "win"                   -> m.win,
      "hardwareVsModel"       -> ujson.Obj("pixelsDifferent" -> f.pixelsDifferent.toDouble),
      "sync"                  -> ujson.Obj.from(m.sync.map { s =>
        s.name -> ujson.Obj("clocks" -> s.last.toDouble, "measured" -> s.measured.toDouble, "wrong" -> s.wrong.toDouble)
      }),
      "engineSeconds" -> seconds
    )

  /** What must be zero and is not. */
  def failures(m: PongMeasures, f: PongFigures): Seq[String] =
    (if (m.syncErrors > 0)
       Seq(m.sync.filter(_.wrong > 0).map(s => s"${s.name} ${s.wrong} times").mkString("sync is wrong: ", ", ", ""))
     else Nil) ++ f.failures
}
