package frustum.command.chart

import frustum.boards.flow.MissingTool
import frustum.BuildInfo
import frustum.charts.systems._
import frustum.command.common.{Arguments, Page, Progress}
import frustum.command.render.RenderCommand
import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Camera, Scene}
import frustum.engine.raster.PipelineEngine
import frustum.files.{Notices, OutputFile}
import frustum.scene.{Framing, ObjScene, Scenes}
import scopt.OParser
import java.nio.file.{Path, Paths}
import scala.collection.mutable

/** Arguments of `chart systems`. */
final case class SystemsOptions(
    scenes: Seq[String] = Nil,
    obj: Seq[Path] = Nil,
    synthesis: Boolean = false,
    out: Path = Paths.get("out", "chart", "systems")
)

/** `chart systems`: whole renderers, speed against error, a chart for each scene and for each engine. */
object SystemsChart {
  val name = "systems"

  private val Quad = "quad"
  private val sceneNames = Scenes.names :+ Quad

  private val parser: OParser[_, SystemsOptions] = {
    val builder = OParser.builder[SystemsOptions]
    import builder._
    OParser.sequence(
      programName("./sbt chart systems"),
      head("chart systems: charts speed against error of whole renderers; writes out/chart/systems/index.html"),
      opt[String]("scene")(
        Arguments.oneOf(sceneNames.map(n => n -> n): _*)
      ).valueName(sceneNames.mkString("|")).unbounded()
        .action((v, o) => o.copy(scenes = o.scenes :+ v))
        .text("this one alone; may be given several times (default: all of them, rays and voxels)"),
      opt[Path]("obj")(Arguments.file).valueName("FILE").unbounded().action((v, o) => o.copy(obj = o.obj :+ v))
        .text("a mesh to chart as well: OBJ with MTL and pictures; may be given several times"),
      opt[Unit]("synthesis").action((_, o) => o.copy(synthesis = true)).text(
        "places what has no placed clock yet, and simulates what was made for one scene; takes hours the first time\n" +
          "(default: clocks, areas and cycles that earlier runs have left, for the same Verilog)"
      ),
      opt[Path]("out")(
        Arguments.file
      ).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/chart/systems)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse("chart systems", parser, args, SystemsOptions()).fold(0)(chart)

  private def chart(o: SystemsOptions): Int = {
    val wanted = if (o.scenes.isEmpty) sceneNames else o.scenes.distinct
    val scenes = wanted.map(n => if (n == Quad) quad else Scenes.byName(n))
    val others = o.scenes.isEmpty // rays and voxels
    val meshes = o.obj.map(mesh)
    val doubles = (scenes ++ meshes).map(_.name).diff((scenes ++ meshes).map(_.name).distinct)
    doubles.headOption.foreach(n => throw InputError(s"--obj: a chart is named $n already; rename the file"))
    OutputFile.check(o.out.resolve("index.html"))
    def say(line: String): Unit = println(s"chart systems: $line")
    val progress = Progress("chart systems", scenes.length + meshes.length + (if (others) 2 else 0))
    val charts = mutable.ArrayBuffer.empty[SystemChart]
    def take(c: SystemChart): Unit = {
      c.write(o.out)
      charts += c
      progress.step()
    }
    try {
      val tops = new PlacedTops(Option.when(o.synthesis)(PlacedTops.flow(say)))
      new RasterSystems(
        tops,
        new SystemCycles(SystemCycles.simulation),
        o.synthesis,
        PipelineEngine.compile(_),
        Some(PeerFigures.read()),
        say
      ).charts(scenes ++ meshes, take)
      if (others) {
        val reported = new PlacedTops(None) // other parts' tools, and pins that no variant has
        take(new RaySystems(reported).chart)
        take(new VoxelSystems(reported).chart)
      }
    } catch { case MissingTool(message) => throw InputError(s"$message; or leave out --synthesis") }
    finally progress.close()
    OutputFile.writeText(o.out.resolve("systems.json"), ujson.write(json(charts.toSeq), indent = 2) + "\n")
    OutputFile.writeText(
      o.out.resolve("index.html"),
      Page("Frustum: speed against accuracy of whole systems", charts.map(figures(o.out, _)).mkString("\n"))
    )
    println(s"wrote ${o.out.resolve("index.html")}, ${charts.map(_.pictures.length).sum} charts")
    0
  }

  /** The full-screen quad that the compared system's texels were counted on, see docs/results.md. */
  private def quad: Scene = {
    val config = RasterConfig()
    val folder = Paths.get("sim", "scenes")
    val aspect = config.width.toDouble / config.height
    val options = ObjScene.Options(Some(folder.resolve("quad.png")), None, config.textureTexels, aspect)
    ObjScene.read(folder.resolve("quad.obj"), options)
      .copy(name = Quad, camera = Camera(Vector3(0, 0, 2), Vector3.Zero, Vector3(0, 1, 0), 45, 1, 3, Some(2.0)))
  }

  /** A mesh as `render` frames it. */
  private def mesh(file: Path): Scene = {
    val config = RasterConfig()
    val aspect = config.width.toDouble / config.height
    val read = RenderCommand.sceneOf(None, Some(file), ObjScene.Options(None, None, config.textureTexels, aspect))
    Notices.print(read.notices)
    read.copy(
      name = file.getFileName.toString.replaceFirst("\\.[^.]*$", ""),
      camera = Framing(read.boundingSphere, aspect, read.camera.fovDegrees)
    )
  }

  private def figures(out: Path, c: SystemChart): String =
    c.pictures.map(p => Page.chart(c.title, out.resolve(s"$p.png"), c.note, s"${c.name}.csv")).mkString("\n")

  private def json(charts: Seq[SystemChart]) = ujson.Obj(
    "command" -> "chart systems",
    "version" -> BuildInfo.version,
    "seed" -> 1,
    "engine" -> "model",
    "charts" -> charts.map(_.json)
  )
}
