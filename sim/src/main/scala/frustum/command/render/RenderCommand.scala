package frustum.command.render

import frustum.command.common.{Arguments, CommandLine}
import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.driver.raster.DrawOptions
import frustum.driver.scene.{Camera, Material, Scene}
import frustum.engine.raster.EngineOptions
import frustum.files.{Notices, OutputFile}
import frustum.picture.Picture
import frustum.scene.{Framing, MaterialPictures, ObjScene, Scenes}
import java.nio.file.{Path, Paths}

/** `render`: draws a scene, or a mesh, with an engine; writes the picture and a report. */
object RenderCommand extends CommandLine {
  val name = "render"
  val summary = "draws a scene or a mesh; writes out/render/SCENE.png and a report"

  def run(args: Seq[String]): Int =
    Arguments.parse(name, RenderOptions.parser, args, RenderOptions()).fold(0)(render)

  private def render(o: RenderOptions): Int = {
    val entry = o.engine
    if (o.wave.isDefined && !entry.kind.simulated)
      throw InputError(s"--wave: the engine ${entry.name} has no signals; use --engine hardware or pipeline")
    if (o.panel.isDefined && !entry.kind.atPins)
      throw InputError(s"--panel: the engine ${entry.name} has no display; use --engine hardware")
    val config = configOf(o.size._1, o.size._2)
    val aspect = config.width.toDouble / config.height
    val scene = sceneOf(o.scene, o.obj, ObjScene.Options(o.texture, o.textureSize, config.textureTexels, aspect))
    if (o.strict) Notices.refuse(scene.notices)
    val stem = o.obj.fold(scene.name)(_.getFileName.toString.replaceFirst("\\.[^.]*$", ""))
    val folder = Paths.get("out", name)
    val out = o.out.getOrElse(folder.resolve(if (o.frames > 1) s"$stem-%d.png" else s"$stem.png"))
    val report = o.report.getOrElse(folder.resolve(s"$stem.json"))
    if (o.frames > 1 && !out.getFileName.toString.contains("%d"))
      throw InputError(
        s"--out: $out names one file for ${o.frames} frames; put %d where the frame's number goes"
      )
    if (report.toAbsolutePath.normalize == out.toAbsolutePath.normalize)
      throw InputError(s"--report: $report is the picture's file as well; name another")
    OutputFile.check((numbered(out, 0) +: report +: o.wave.toSeq): _*)

    val run = SceneRun(
      scene.copy(name = stem),
      o.obj.fold(cameraOf(o, scene.camera))(_ => framed(o, scene, aspect)),
      DrawOptions(o.light, o.cullBack, o.wrap, o.background),
      config,
      o.frames,
      o.turn.getOrElse(360.0 / o.frames),
      entry,
      EngineOptions(o.seed, o.wave, o.panel.getOrElse(Panel.Ili9341))
    )
    val figures = run.figures((frame, verdict) =>
      Picture.writePng(numbered(out, frame), config.width, config.height, verdict.picture)
    )
    OutputFile.writeText(report, ujson.write(RenderReport.json(name, o.seed, figures), indent = 2) + "\n")
    println(s"wrote ${if (o.frames > 1) s"$out, ${o.frames} frames" else out} and $report")
    figures.verdict(report, figures.endToEnd.toSeq.flatMap(e => EndToEndBounds.failures(EndToEndBounds.ofAny(e), e)))
  }

  private def numbered(out: Path, frame: Int): Path =
    Option(out.getParent).fold(Paths.get(""))(identity).resolve(out.getFileName.toString.replace(
      "%d",
      frame.toString
    ))

  def configOf(width: Int, height: Int): RasterConfig =
    try RasterConfig(width = width, height = height)
    catch {
      case e: IllegalArgumentException =>
        throw InputError(
          s"--size ${width}x$height: ${e.getMessage.stripPrefix("requirement failed: ")}; take another"
        )
    }

  /** What `--scene`, `--obj` and the options about pictures ask for. */
  def sceneOf(name: Option[String], obj: Option[Path], options: ObjScene.Options): Scene = (name, obj) match {
    case (Some(_), Some(_)) => throw InputError("--obj: a scene is given as well; leave out --obj or --scene")
    case (_, Some(file))    => ObjScene.read(file, options)
    case (scene, None)      =>
      val made = Scenes.byName(scene.getOrElse("teapot"))
      val notices = new Notices
      val picture =
        new MaterialPictures(options.texels, options.textureSize, options.texture, notices).read(Seq(None)).get(None)
      picture.fold(made)(p =>
        made.copy(
          materials = made.materials.map(m => Material.textured(m.name, p.image, m.alpha)),
          notices = notices.result
        )
      )
  }

  private def framed(o: RenderOptions, scene: Scene, aspect: Double): Camera = {
    val own = scene.camera
    Framing(scene.boundingSphere, aspect, o.fov.getOrElse(own.fovDegrees), o.eye, o.at, o.up, o.near, o.far, o.ortho)
  }

  private def cameraOf(o: RenderOptions, own: Camera): Camera = Camera(
    o.eye.getOrElse(own.eye),
    o.at.getOrElse(own.at),
    o.up.getOrElse(own.up),
    o.fov.getOrElse(own.fovDegrees),
    o.near.getOrElse(own.near),
    o.far.getOrElse(own.far),
    o.ortho.orElse(own.orthoHeight)
  )
}
