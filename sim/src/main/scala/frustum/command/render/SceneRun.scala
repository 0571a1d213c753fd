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
import scala.collection.mutable

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

  /** Draws and judges every frame as it comes; `each` is handed one after the other, so that no more pictures are kept
    * than the engine is ahead. Whatever is wrong with the input shows before the first is drawn: every frame is
    * prepared twice, which takes less than keeping it.
    */
  def figures(each: (Int, FrameVerdict) => Unit): SceneFigures = {
    val first = prepared(0)
    val notices = scene.notices ++ emptyFrames(first)
    Notices.print(notices)
    println(
      s"${scene.name}: ${first.trianglesDrawn} triangles, " +
        s"${config.width} x ${config.height}, engine ${entry.name}" +
        (if (entry.kind.atPins) s", display ${engineOptions.panel.name}" else "")
    )
    val judge =
      new FrameJudge(if (entry.kind == EngineKind.Reference) None else RasterEngines.model, entry.kind.simulated)
    val taken = mutable.Queue.empty[PreparedFrame] // by the engine, perhaps in a thread of its own; not judged yet
    val works = (0 until frames).iterator.map { i =>
      val frame = if (i == 0) first else prepared(i)
      taken.synchronized(taken += frame)
      frame
    }
    val verdicts = mutable.ArrayBuffer.empty[FrameFigures]
    var judging = 0L
    val progress = Progress(scene.name, frames)
    val started = System.nanoTime
    try entry.make(engineOptions).draw(works) { drawn =>
        val since = System.nanoTime
        val frame = taken.synchronized(taken.dequeue())
        val i = verdicts.length
        val verdict = judge.judge(frame, drawn, Some(EndToEndJudge.view(scene, camera, turned(i), config)))
        each(i, verdict)
        verdicts += FrameFigures(frame, drawn, verdict)
        progress.step()
        judging += System.nanoTime - since
      }
    finally progress.close()
    val seconds = (System.nanoTime - started - judging) / 1e9
    SceneFigures(scene.name, entry.name, config, verdicts.toSeq, seconds, notices)
  }

  private def prepared(frame: Int): PreparedFrame = Driver.prepare(scene, camera, turned(frame), config, frame)

  /** Frames in which nothing is to be seen, by the cause of the first of them. */
  private def emptyFrames(first: PreparedFrame): Seq[Notice] = {
    def isEmpty(i: Int) = EmptyView(if (i == 0) first else prepared(i))
    val empty = if (scene.triangles.isEmpty) Nil else (0 until frames).filter(isEmpty)
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
