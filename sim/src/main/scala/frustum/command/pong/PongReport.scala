package frustum.command.pong

import frustum.BuildInfo
import frustum.demos.pong.PongPipelineConfig
import frustum.files.{InfinityAsNull, OutputFile}
import java.nio.file.Path

/** The JSON report of `pong`, and of pong in `demo`. */
object PongReport {
  def json(command: String, seed: Long, c: PongPipelineConfig, recording: PongRecording): ujson.Obj = {
    val f = recording.figures.rays
    val report = ujson.Obj(
      "command" -> command,
      "version" -> BuildInfo.version,
      "seed" -> seed.toDouble,
      "engine" -> recording.engine.name,
      "scene" -> "pong",
      "mode" -> c.mode.name,
      "width" -> c.mode.width,
      "height" -> c.mode.height,
      "format" -> c.format.name,
      "frames" -> (recording.last.index + 1),
      "framesJudged" -> recording.judged
    )
    for (m <- recording.last.measures) {
      report("clocksPerFrame") = m.clocksPerFrame.toDouble
      report("pixelsPerClock") = m.pixelsPerClock
      report("latencyClocks") = m.latencyClocks
      report("syncErrors") = m.syncErrors.toDouble
    }
    report("silhouettePixelsWrong") = f.silhouettePixelsWrong.toDouble
    report("shadowPixelsWrong") = f.shadowPixelsWrong.toDouble
    report("objectPixelsWrong") = f.objectPixelsWrong.toDouble
    report("checkerCellsWrong") = f.checkerCellsWrong.toDouble
    report("maxColourError") = f.maxColourError
    report("colourErrorsOver1") = f.colourErrorsOver1.toDouble
    report("psnr") = InfinityAsNull.write(f.psnr)
    report("score") = recording.last.score
    report("win") = recording.last.win
    if (recording.engine.kind.simulated)
      report("hardwareVsModel") = ujson.Obj("pixelsDifferent" -> recording.figures.pixelsDifferent.toDouble)
    for (m <- recording.last.measures) report("sync") = ujson.Obj.from(m.sync.map { s =>
      s.name -> ujson.Obj("clocks" -> s.last.toDouble, "measured" -> s.measured.toDouble, "wrong" -> s.wrong.toDouble)
    })
    report("engineSeconds") = recording.seconds
    report
  }

  /** Writes the report and says what must be zero and is not; gives the exit code. */
  def write(file: Path, report: ujson.Obj, recording: PongRecording): Int = {
    OutputFile.writeText(file, ujson.write(report, indent = 2) + "\n")
    val sync = recording.last.measures.filter(_.syncErrors > 0).map { m =>
      m.sync.filter(_.wrong > 0).map(s => s"${s.name} ${s.wrong} times").mkString("sync is wrong: ", ", ", "")
    }
    val failures = sync ++ recording.figures.failures
    failures.foreach(f => Console.err.println(s"error: pong: $f; see $file"))
    if (failures.isEmpty) 0 else 1
  }
}
