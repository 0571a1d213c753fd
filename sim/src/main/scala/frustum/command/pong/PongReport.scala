package frustum.command.pong

import frustum.BuildInfo
import frustum.demos.pong.PongPipelineConfig
import frustum.engine.pong.PongEngines
import frustum.files.{InfinityAsNull, OutputFile}
import java.nio.file.Path

/** The JSON report of `pong`, and of pong in `demo`. */
object PongReport {
  def json(command: String, seed: Long, c: PongPipelineConfig, recording: PongRecording): ujson.Obj = {
    val (m, f) = (recording.measures, recording.figures.rays)
    ujson.Obj(
      "command" -> command,
      "version" -> BuildInfo.version,
      "seed" -> seed.toDouble,
      "engine" -> PongEngines.default.name,
      "scene" -> "pong",
      "mode" -> c.mode.name,
      "width" -> c.mode.width,
      "height" -> c.mode.height,
      "format" -> c.format.name,
      "frames" -> m.frames.toDouble,
      "framesJudged" -> recording.judged,
      "clocksPerFrame" -> m.clocksPerFrame.toDouble,
      "pixelsPerClock" -> m.pixelsPerClock,
      "latencyClocks" -> m.latencyClocks,
      "syncErrors" -> m.syncErrors.toDouble,
      "silhouettePixelsWrong" -> f.silhouettePixelsWrong.toDouble,
      "shadowPixelsWrong" -> f.shadowPixelsWrong.toDouble,
      "objectPixelsWrong" -> f.objectPixelsWrong.toDouble,
      "checkerCellsWrong" -> f.checkerCellsWrong.toDouble,
      "maxColourError" -> f.maxColourError,
      "colourErrorsOver1" -> f.colourErrorsOver1.toDouble,
      "psnr" -> InfinityAsNull.write(f.psnr),
      "score" -> m.score,
      "win" -> m.win,
      "hardwareVsModel" -> ujson.Obj("pixelsDifferent" -> recording.figures.pixelsDifferent.toDouble),
      "sync" -> ujson.Obj.from(m.sync.map { s =>
        s.name -> ujson.Obj(
          "clocks" -> s.last.toDouble,
          "measured" -> s.measured.toDouble,
          "wrong" -> s.wrong.toDouble
        )
      }),
      "engineSeconds" -> recording.seconds
    )
  }

  /** Writes the report and says what must be zero and is not; gives the exit code. */
  def write(file: Path, report: ujson.Obj, recording: PongRecording): Int = {
    OutputFile.writeText(file, ujson.write(report, indent = 2) + "\n")
    val wrong = recording.measures.sync.filter(_.wrong > 0).map(s => s"${s.name} ${s.wrong} times")
    val sync = Option.when(recording.measures.syncErrors > 0)(wrong.mkString("sync is wrong: ", ", ", ""))
    val failures = sync ++ recording.figures.failures
    failures.foreach(f => Console.err.println(s"error: pong: $f; see $file"))
    if (failures.isEmpty) 0 else 1
  }
}
