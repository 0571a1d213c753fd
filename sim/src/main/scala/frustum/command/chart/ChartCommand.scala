package frustum.command.chart

import frustum.boards.flow.MissingTool
import frustum.BuildInfo
import frustum.charts.{Chart, ChartFamily}
import frustum.command.common.{Arguments, CommandLine, Page, Progress}
import frustum.contract.InputError
import frustum.files.OutputFile
import frustum.synthesis.UnitCosts
import scopt.OParser
import java.nio.file.{Path, Paths}

/** Arguments of `chart`. */
final case class ChartOptions(
    family: Option[ChartFamily] = None,
    synthesis: Boolean = true,
    out: Path = Paths.get("out", "chart")
)

/** `chart`: error against cost, family by family. */
object ChartCommand extends CommandLine {
  val name = "chart"
  val summary = "charts accuracy against cost; writes the page out/chart/index.html"

  private val names = ChartFamily.all.map(_.name)
  private val parser: OParser[_, ChartOptions] = {
    val builder = OParser.builder[ChartOptions]
    import builder._
    OParser.sequence(
      programName("./sbt chart"),
      head(s"chart: $summary"),
      arg[ChartFamily]("FAMILY")(Arguments.oneOf(ChartFamily.all.map(f => f.name -> f): _*)).optional()
        .action((v, o) => o.copy(family = Some(v)))
        .text(
          s"one of ${names.mkString(", ")} (default: all),\nor ${SystemsChart.name}: see ./sbt \"chart systems --help\""
        ),
      opt[Unit]("no-synthesis").action((_, o) => o.copy(synthesis = false))
        .text("without yosys: families whose cost is cells show bits instead or are left out"),
      opt[Path]("out")(
        Arguments.file
      ).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/chart)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int =
    if (args.headOption.contains(SystemsChart.name)) SystemsChart.run(args.tail)
    else {
      val family = args.headOption.filterNot(_.startsWith("-"))
      for (f <- family if !names.contains(f)) throw NearestName.unknown("FAMILY", f, names :+ SystemsChart.name)
      Arguments.parse(name, parser, args, ChartOptions()).fold(0)(chart)
    }

  private def chart(o: ChartOptions): Int = {
    val families = o.family.fold(ChartFamily.all)(Seq(_))
    val progress = Progress(name, families.length)
    val charts =
      try {
        val costs = Option.when(o.synthesis)(new UnitCosts(step => println(s"chart: $step")))
        families.flatMap { family =>
          val charts = family.charts(costs)
          charts.foreach(_.write(o.out))
          progress.step()
          charts
        }
      } catch { case MissingTool(message) => throw InputError(s"$message; or give --no-synthesis") }
      finally progress.close()
    OutputFile.writeText(o.out.resolve("chart.json"), ujson.write(json(charts), indent = 2) + "\n")
    OutputFile.writeText(
      o.out.resolve("index.html"),
      Page("Frustum: accuracy against cost", charts.map(figure(o.out, _)).mkString("\n"))
    )
    println(s"wrote ${o.out.resolve("index.html")}, ${charts.length} charts")
    0
  }

  private def figure(out: Path, c: Chart): String =
    Page.chart(c.title, out.resolve(s"${c.name}.png"), c.note, s"${c.name}.csv")

  private def json(charts: Seq[Chart]) = ujson.Obj(
    "command" -> name,
    "version" -> BuildInfo.version,
    "seed" -> 1,
    "engine" -> "model",
    "charts" -> charts.map { c =>
      ujson.Obj(
        "name" -> c.name,
        "title" -> c.title,
        "note" -> c.note,
        "costAxis" -> c.costAxis,
        "errorAxis" -> c.errorAxis,
        "points" -> c.points.map { p =>
          val point = ujson.Obj(
            "method" -> p.method,
            "setting" -> p.setting,
            "cost" -> p.cost,
            "error" -> p.error,
            "shipped" -> c.shipped.contains(p),
            "peer" -> c.peer.contains(p),
            "front" -> c.front.contains(p)
          )
          for (unit <- p.hardware; (figure, Some(value)) <- unit.figures) point(figure) = value
          point
        }
      )
    }
  )
}
