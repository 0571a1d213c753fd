package frustum.command.stability

import frustum.BuildInfo
import frustum.command.common.{Arguments, CommandLine, Page, Progress}
import frustum.files.OutputFile
import frustum.stability.{StabilityMap, Sweep, SweepResult}
import scopt.OParser
import java.nio.file.{Path, Paths}

/** Arguments of `stability`. */
final case class StabilityOptions(method: Option[String] = None, out: Path = Paths.get("out", "stability"))

/** `stability`: each method within its declared domain and beyond it. */
object StabilityCommand extends CommandLine {
  val name = "stability"
  val summary = "finds where each method fails; writes the map out/stability/index.html"

  private val methods = Sweep.all.map(_.domain.method).distinct
  private val parser: OParser[_, StabilityOptions] = {
    val builder = OParser.builder[StabilityOptions]
    import builder._
    OParser.sequence(
      programName("./sbt stability"),
      head(s"stability: $summary"),
      arg[String]("METHOD")(Arguments.oneOf(methods.map(m => m -> m): _*)).optional()
        .action((v, o) => o.copy(method = Some(v))).text(s"one of ${methods.mkString(", ")} (default: all)"),
      opt[Path]("out")(
        Arguments.file
      ).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/stability)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, StabilityOptions()).fold(0)(stability)

  private def stability(o: StabilityOptions): Int = {
    val sweeps = Sweep.all.filter(s => o.method.forall(_ == s.domain.method))
    val progress = Progress(name, sweeps.length)
    val results =
      try sweeps.map { sweep =>
          val result = sweep.run()
          progress.step()
          result
        }
      finally progress.close()
    val failures = results.flatMap(_.failures)
    write(o.out, results, failures)
    println(s"wrote ${o.out.resolve("index.html")}, ${results.length} sweeps")
    failures.foreach(f => Console.err.println(s"error: stability: $f"))
    if (failures.isEmpty) 0 else 1
  }

  private def write(out: Path, results: Seq[SweepResult], failures: Seq[String]): Unit = {
    StabilityMap.write(out, results)
    val csv = "method,quantity,unit,value,state,error,error unit,reason" +: results.flatMap(r =>
      r.trials.map(t =>
        Seq(
          r.sweep.domain.method,
          r.sweep.name,
          r.sweep.domain.unit,
          t.value.toString,
          t.state.name,
          t.error.mkString,
          r.sweep.domain.errorUnit,
          t.reason.mkString
        ).map(quoted).mkString(",")
      )
    )
    OutputFile.writeText(out.resolve("stability.csv"), csv.mkString("", "\n", "\n"))
    OutputFile.writeText(
      out.resolve("stability.json"),
      ujson.write(
        ujson.Obj(
          "command" -> name,
          "version" -> BuildInfo.version,
          "seed" -> 1,
          "engine" -> "model",
          "failures" -> failures,
          "sweeps" -> results.map(json)
        ),
        indent = 2
      ) + "\n"
    )
    val picture = Page.source(out.resolve("map.png"))
    val rows = results.map(row).mkString("\n")
    val headers =
      Seq("method", "what it depends on", "declared", "bound", "found", "compared systems", "refused because")
    OutputFile.writeText(
      out.resolve("index.html"),
      Page(
        "Frustum: where methods fail",
        s"""<figure><img alt="map" src="$picture">
           |<figcaption>${StabilityMap.HowToRead}
           |Data: stability.csv; the same picture as map.svg.</figcaption></figure>
           |<table><tr>${headers.map(h => s"<th>$h</th>").mkString}</tr>
           |$rows
           |</table>""".stripMargin
      )
    )
  }

  private def quoted(s: String) =
    if (s.contains(',') || s.contains('"')) "\"" + s.replace("\"", "\"\"") + "\"" else s

  private def row(r: SweepResult): String = {
    val d = r.sweep.domain
    val found = r.stretches.map { case (a, b, s) =>
      s"${StabilityMap.shortest(a)} to ${StabilityMap.shortest(b)}: ${s.name}"
    }
    val refused = r.trials.flatMap(_.reason).distinct.take(1)
    val mark = if (r.failures.isEmpty) "" else " class=\"over\""
    Seq(
      d.method,
      s"${d.quantity}, ${d.unit}",
      s"${StabilityMap.shortest(d.low)} to ${StabilityMap.shortest(d.high)}",
      s"${StabilityMap.shortest(d.bound)} ${d.errorUnit}",
      found.mkString("<br>"),
      r.sweep.peer.fold("")(p =>
        p.range.fold("") { case (low, high) =>
          s"${StabilityMap.shortest(low)} to ${StabilityMap.shortest(high)}: "
        } + p.what
      ),
      refused.mkString
    ).map(c => s"<td>$c</td>").mkString(s"<tr$mark>", "", "</tr>")
  }

  private def json(r: SweepResult) = {
    val d = r.sweep.domain
    ujson.Obj(
      "method" -> d.method,
      "quantity" -> d.quantity,
      "unit" -> d.unit,
      "validFor" -> ujson.Obj("low" -> d.low, "high" -> d.high),
      "bound" -> d.bound,
      "errorUnit" -> d.errorUnit,
      "worst" -> r.trials.filter(t => d.contains(t.value)).flatMap(
        _.error
      ).maxOption.fold[ujson.Value](ujson.Null)(ujson.Num(_)),
      "borders" -> r.borders.map(b =>
        ujson.Obj("value" -> b.value, "below" -> b.below.name, "above" -> b.above.name)
      ),
      "peer" -> r.sweep.peer.fold[ujson.Value](ujson.Null)(p =>
        ujson.Obj.from(p.range.toSeq.flatMap { case (low, high) =>
          Seq("low" -> ujson.Num(low), "high" -> ujson.Num(high))
        } :+ ("what" -> ujson.Str(p.what)))
      )
    )
  }
}
