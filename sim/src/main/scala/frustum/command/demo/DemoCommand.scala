package frustum.command.demo

import frustum.command.common.{Arguments, CommandLine, ReportTable}
import frustum.command.render.{EndToEndBounds, RenderReport, SceneFigures, SceneRun}
import frustum.contract.raster.RasterConfig
import frustum.engine.pong.PongEngines
import frustum.engine.raster.{EngineOptions, RasterEngineEntry, RasterEngines}
import frustum.engine.voxel.VoxelEngines
import frustum.files.OutputFile
import frustum.picture.Picture
import frustum.scene.Scenes
import scopt.OParser
import java.nio.file.{Path, Paths}

/** Arguments of `demo`. */
final case class DemoOptions(
    engine: RasterEngineEntry = RasterEngines.default,
    out: Path = Paths.get("out", "demo"),
    seed: Long = 1
)

/** `demo`: every scene, with its picture, the reference's and their difference on one page. */
object DemoCommand extends CommandLine {
  val name = "demo"
  val summary = "draws every scene; writes the page out/demo/index.html"

  private val parser: OParser[_, DemoOptions] = {
    val builder = OParser.builder[DemoOptions]
    import builder._
    OParser.sequence(
      programName("./sbt demo"),
      head(s"demo: $summary"),
      opt[RasterEngineEntry]("engine")(Arguments.engine(RasterEngines)).valueName(RasterEngines.names.mkString("|"))
        .action((v, o) => o.copy(engine = v)).text(s"what draws (default ${RasterEngines.default.name})"),
      opt[Path]("out")(
        Arguments.file
      ).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/demo)"),
      opt[Long]("seed")(Arguments.seed).valueName("N").action((v, o) => o.copy(seed = v))
        .text("of whatever is random (default 1)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, DemoOptions()).fold(0)(demo)

  private def demo(o: DemoOptions): Int = {
    val config = RasterConfig()
    val shown = for (sceneName <- Scenes.names) yield {
      val scene = Scenes.byName(sceneName)
      val run = SceneRun.still(scene, config, o.engine, EngineOptions(o.seed, None))
      val figures = run.figures { (_, v) =>
        DemoPictures.write(o.out, sceneName, config.width, config.height, v.picture, v.reference)
        for (e <- v.endToEnd)
          Picture.writePng(o.out.resolve(s"$sceneName.referee.png"), config.width, config.height, e.picture)
      }
      val report = RenderReport.json(name, o.seed, figures)
      OutputFile.writeText(o.out.resolve(s"$sceneName.json"), ujson.write(report, indent = 2) + "\n")
      (figures, report)
    }
    // Where they have an engine of that name.
    val pong = PongEngines.find(o.engine.name).map(PongDemo(o.out, o.seed, _))
    val voxel = VoxelEngines.find(o.engine.name).map(VoxelDemo(o.out, _))
    val others = pong ++ voxel
    val reports = shown.map(_._2) ++ others.map(_._1)
    OutputFile.writeText(o.out.resolve("index.html"), DemoPage(o.out, reports))
    println(ReportTable(reports))
    println(s"wrote ${o.out.resolve("index.html")}")
    (shown.map { case (f, _) => f.verdict(o.out.resolve(s"${f.scene}.json"), beyondBounds(f)) } ++ others.map(_._2)).max
  }

  /** The bounds of a scene are those of the hardware; the float64 reference has those of any picture. */
  private def beyondBounds(f: SceneFigures): Seq[String] = f.endToEnd.toSeq.flatMap { e =>
    EndToEndBounds.failures(if (f.model.isEmpty) EndToEndBounds.ofAny(e) else EndToEndBounds.ofScene(f.scene, e), e)
  }
}
