package frustum.command.render

import frustum.command.common.Progress
import frustum.contract.raster.{RasterConfig, Wrap}
import frustum.driver.raster.{DrawOptions, Driver, EmptyView, PreparedFrame}
import frustum.driver.scene.{Camera, Scene}
import frustum.engine.EngineKind
import frustum.engine.raster.{EngineOptions, RasterEngineEntry, RasterEngines}
import frustum.driver.scene.Notice
import frustum.files.Notices
import frustum.judge.{EndToEndJudge, FrameJudge, FrameVerdict}

/** A scene on its way through driver, engine and judges.
  *
  * @param turnDegrees from each frame to the next
  */
final case class SceneRun(
    scene: Scene,
    camera: Camera,
    options: DrawOptions,
    config: RasterConfig,
    frames: Int,
    turnDegrees: Double,
    entry: RasterEngineEntry,
    engineOptions: EngineOptions
) {

  /** Draws and judges every frame; `each` is handed one after the other, so that no more than one picture is
    * kept. Whatever is wrong with the input shows before the first is drawn.
    */
  def figures(each: (Int, FrameVerdict) => Unit): SceneFigures = {
    val prepared: Seq[PreparedFrame] = (0 until frames).map { i =>
      Driver.prepare(scene, camera, turned(i), config, i)
    }
    val notices = scene.notices ++ emptyFrames(prepared)
    Notices.print(notices)
    println(
      s"${scene.name}: ${prepared.head.trianglesDrawn} triangles, " +
        s"${config.width} x ${config.height}, engine ${entry.name}" +
        (if (entry.kind.atPins) s", display ${engineOptions.panel.name}" else "")
    )
    val started = System.nanoTime
    val rendered = entry.make(engineOptions).drawAll(prepared)
    val seconds = (System.nanoTime - started) / 1e9
    val model = if (entry.kind == EngineKind.Reference) None else RasterEngines.model
    val judge = new FrameJudge(model, entry.kind.simulated)
    val progress = Progress(scene.name, frames)
    val verdicts =
      try prepared.zip(rendered).zipWithIndex.map { case ((frame, drawn), i) =>
          val verdict = judge.judge(frame, drawn, Some(EndToEndJudge.view(scene, camera, turned(i), config)))
          each(i, verdict)
          progress.step()
          FrameFigures(frame, drawn, verdict)
        }
      finally progress.close()
    SceneFigures(scene.name, entry.name, config, verdicts, seconds, notices)
  }

  /** Frames in which nothing is to be seen, by the cause of the first of them. */
  private def emptyFrames(prepared: Seq[PreparedFrame]): Seq[Notice] = {
    val empty = prepared.indices.filter(i => scene.triangles.nonEmpty && EmptyView(prepared(i)))
    empty.headOption.map { i =>
      val causes = EmptyView.cause(scene, camera, turned(i), config) +: EmptyView.leftOut(prepared(i)).toSeq
      Notice(s"${scene.place}: ${causes.mkString("; ")}", empty.length.toLong)
    }.toSeq
  }

  private def turned(frame: Int): DrawOptions = options.copy(turnDegrees = options.turnDegrees + frame * turnDegrees)
}

object SceneRun {

  /** One frame from the scene's own camera, as it is without arguments. */
  def still(scene: Scene, config: RasterConfig, entry: RasterEngineEntry, engineOptions: EngineOptions): SceneRun =
    SceneRun(
      scene,
      scene.camera,
      DrawOptions(None, cullBack = false, Wrap.Repeat, scene.background),
      config,
      frames = 1,
      turnDegrees = 0,
      entry,
      engineOptions
    )
}
