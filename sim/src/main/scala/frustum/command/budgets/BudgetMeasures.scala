package frustum.command.budgets

import frustum.budgets.{Budget, Measured}
import frustum.command.pong.PongScenes
import frustum.command.render.{EndToEndBounds, RenderReport, SceneRun}
import frustum.command.voxel.{JudgedViews, ViewFigures, VoxelOptions, VoxelReport, VoxelScenes}
import frustum.contract.raster.RasterConfig
import frustum.contract.video.VideoMode
import frustum.contract.voxel.LeapField
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.engine.voxel.VoxelEngines
import frustum.files.InfinityAsNull
import frustum.judge.{RayCounts, RayJudge, TemporalJudge}
import frustum.model.demos.pong.PongGame
import frustum.model.ray.RayPicture
import frustum.play.AutoPlayer
import frustum.scene.Scenes

/** The figures of every scene, from the bit-exact models; hardware equals them, or other tests fail. */
object BudgetMeasures {

  /** Names of what can be measured. */
  val scenes: Seq[String] = Budget.AnyPicture +: (Scenes.names ++ Seq("pong", "voxel"))

  def apply(scene: String): Seq[Measured] = scene match {
    case Budget.AnyPicture => AnyPictures.measured()
    case "pong"            => pong()
    case "voxel"           => voxel()
    case _                 => raster(scene)
  }

  private val rasterMetrics = Seq(
    "modelVsReference" -> Seq(
      "coverageWrong",
      "texelsWrong",
      "texelsWrongByMoreThanOne",
      "maxTexelError",
      "primitiveWrong",
      "depthOrderWrong",
      "psnr"
    ),
    "snapping" -> Seq("coverageWrong", "texelsWrong", "psnr", "flip")
  )

  private def raster(name: String): Seq[Measured] = {
    val run =
      SceneRun.still(Scenes.byName(name), RasterConfig(), RasterEngines.byName("model"), EngineOptions(1, None))
    val figures = run.figures((_, _) => ())
    val report = RenderReport.json("budgets", 1, figures)
    val still = for ((group, metrics) <- rasterMetrics; metric <- metrics)
      yield Measured(name, s"$group.$metric", InfinityAsNull.read(report(group)(metric)))
    still ++ figures.endToEnd.toSeq.flatMap(EndToEndBounds.ofScene(name, _)) ++ pan(name)
  }

  /** Panned by 1/16 pixel from picture to picture. */
  private def pan(name: String): Seq[Measured] = {
    val t = TemporalJudge.pan(Scenes.byName(name), TemporalJudge.Config, TemporalJudge.SubpixelBits)
    Seq("swimRms" -> t.swimRms, "swimMost" -> t.swimMost, "popsPercent" -> t.popsPercent).map {
      case (metric, value) =>
        Measured(name, s"temporal.$metric", value)
    }
  }

  /** All of it with the leaps that the figures have always been of, and steps with those that the boards have. */
  private def voxel(): Seq[Measured] = {
    def measured(report: ujson.Obj, metric: String, as: String) =
      Measured("voxel", as, InfinityAsNull.read(report(metric)))
    val all = hills(LeapField.Octants)
    Seq("blocksWrong", "facesWrong", "texelsWrong", "maxDirectionErrorPixels", "steps", "psnr")
      .map(metric => measured(all, metric, metric)) ++
      Seq("quadrants" -> LeapField.Quadrants, "up-down" -> LeapField.UpDown)
        .map { case (name, leaps) => measured(hills(leaps), "steps", s"steps.$name") }
  }

  private def hills(leaps: LeapField): ujson.Obj = {
    val o = VoxelOptions(size = (160, 120), engine = VoxelEngines.byName("model"), leaps = Some(leaps))
    val scene = VoxelScenes(o)
    var drawn = Seq.empty[ViewFigures]
    new JudgedViews(scene, o.engine, highlight = false, o.seed).draw(view => drawn :+= view.figures)
    VoxelReport.json("budgets", o.seed, o.engine, scene.config, drawn)
  }

  /** States of a game that plays itself, far apart. */
  private def pong(): Seq[Measured] = {
    val config = PongScenes.config(VideoMode.Vga640x480, None)
    val picture = new RayPicture(config.scene, config.mode.width, config.mode.height)
    val judge = new RayJudge(config.scene, config.mode.width, config.mode.height)
    val states = Iterator.iterate(
      PongGame.start
    )(g => g.tick(AutoPlayer(g))).grouped(PongTicks).map(_.head).take(PongStates)
    val sum = states.map { game =>
      val pixels = picture(game.motion)
      judge(game.motion, pixels.map(_.objectId), pixels.map(_.rgb))
    }.foldLeft(RayCounts.none)(_ + _)
    Seq(
      "silhouettePixelsWrong" -> sum.silhouettePixelsWrong.toDouble,
      "shadowPixelsWrong" -> sum.shadowPixelsWrong.toDouble,
      "objectPixelsWrong" -> sum.objectPixelsWrong.toDouble,
      "checkerCellsWrong" -> sum.checkerCellsWrong.toDouble,
      "maxColourError" -> sum.maxColourError,
      "psnr" -> sum.psnr.getOrElse(Double.PositiveInfinity)
    ).map { case (metric, value) => Measured("pong", metric, value) }
  }
  private val PongTicks = 37
  private val PongStates = 4
}
