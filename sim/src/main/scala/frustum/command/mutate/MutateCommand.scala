package frustum.command.mutate

import frustum.boards.flow.{Ice40Tools, MissingTool}
import frustum.BuildInfo
import frustum.command.common.{Arguments, CommandLine, Page, Progress}
import frustum.contract.InputError
import frustum.files.OutputFile
import frustum.mutation.{MutantNetlist, MutationPlan, MutationPlans, MutationResult, MutationRun}
import scopt.OParser
import java.nio.file.{Path, Paths}

/** Arguments of `mutate`. */
final case class MutateOptions(
    unit: Option[(String, Long => MutationPlan)] = None,
    mutants: Int = 400,
    seed: Long = 1,
    out: Path = Paths.get("out", "mutate")
)

/** `mutate`: how many wrong wires of a unit the test vectors find. */
object MutateCommand extends CommandLine {
  val name = "mutate"
  val summary =
    "breaks wires of a unit one by one and counts which ones its test vectors find; writes out/mutate"

  /** Below this share of kills the command fails. */
  val Least = 95.0

  private val parser: OParser[_, MutateOptions] = {
    val builder = OParser.builder[MutateOptions]
    import builder._
    OParser.sequence(
      programName("./sbt mutate"),
      head(s"mutate: $summary"),
      arg[(String, Long => MutationPlan)]("UNIT")(Arguments.oneOf(MutationPlans.all.map(p =>
        p._1 -> p
      ): _*)).optional()
        .action((v, o) => o.copy(unit = Some(v)))
        .text(s"one of ${MutationPlans.all.map(_._1).mkString(", ")} (default: all)"),
      opt[Int]("mutants")(Arguments.count).valueName("N").action((v, o) => o.copy(mutants = v))
        .validate(n =>
          if (n >= 1 && n <= MutantNetlist.Most) success
          else failure(s"--mutants: $n; give 1 to ${MutantNetlist.Most}")
        )
        .text("mutants of each unit (400)"),
      opt[Long]("seed")(
        Arguments.seed
      ).valueName("N").action((v, o) => o.copy(seed = v)).text("draws mutants and vectors (1)"),
      opt[Path]("out")(
        Arguments.file
      ).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/mutate)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, MutateOptions()).fold(0)(mutate)

  private def mutate(o: MutateOptions): Int = {
    def say(step: String): Unit = println(s"$name: $step")
    val results =
      try {
        val run = new MutationRun(Ice40Tools.find(say).yosys, o.out.resolve("build"), say, watch)
        o.unit.fold(MutationPlans.all)(Seq(_)).map { case (unit, plan) =>
          unit -> run(plan(o.seed), o.mutants, o.seed)
        }
      } catch { case MissingTool(message) => throw InputError(message) }
    OutputFile.writeText(o.out.resolve("mutate.json"), ujson.write(json(o, results), indent = 2) + "\n")
    OutputFile.writeText(o.out.resolve("mutate.csv"), csv(results))
    OutputFile.writeText(o.out.resolve("index.html"), page(results))
    for ((unit, r) <- results)
      println(
        f"$unit%-20s ${r.count}%4d mutants: ${r.killed.length}%4d killed, ${r.equivalent.length}%3d equivalent, " +
          f"${r.survivors.length}%3d survive: ${r.killPercent}%.1f %%"
      )
    println(s"wrote ${o.out.resolve("index.html")}")
    val weak = results.filter(_._2.killPercent < Least)
    weak.foreach { case (unit, r) =>
      Console.err.println(
        f"error: $unit: ${r.killPercent}%.1f %% of the mutants are killed, less than $Least%.0f %%"
      )
    }
    if (weak.isEmpty) 0 else 1
  }

  /** A bar, or lines, for so many mutants. */
  private def watch(task: String, mutants: Int): () => Unit = {
    val progress = Progress(s"$name $task", mutants)
    var left = mutants
    () => {
      progress.step()
      left -= 1
      if (left == 0) progress.close()
    }
  }

  private def json(o: MutateOptions, results: Seq[(String, MutationResult)]) = ujson.Obj(
    "command" -> name,
    "version" -> BuildInfo.version,
    "seed" -> o.seed.toDouble,
    "engine" -> "netlist",
    "units" -> results.map { case (unit, r) =>
      ujson.Obj(
        "unit" -> unit,
        "mutants" -> r.count,
        "steps" -> r.steps,
        "killed" -> r.killed.length,
        "equivalent" -> r.equivalent.length,
        "killPercent" -> r.killPercent,
        "survivors" -> r.survivors.map(_.toString)
      )
    }
  )

  private def csv(results: Seq[(String, MutationResult)]): String = (
    "unit,mutant,mode,cell,port,wire,verdict" +: (for {
      (unit, r) <- results
      (verdict, of) <- Seq("killed" -> r.killed, "equivalent" -> r.equivalent, "survives" -> r.survivors)
      m <- of
    } yield Seq(unit, m.number.toString, m.mode, m.cell, m.port, m.source, verdict).mkString(","))
  ).mkString("", "\n", "\n")

  private def page(results: Seq[(String, MutationResult)]): String = {
    val rows = results.map { case (unit, r) =>
      f"<tr><td>$unit</td><td>${r.count}</td><td>${r.killed.length}</td><td>${r.equivalent.length}</td>" +
        f"<td>${r.survivors.length}</td><td>${r.killPercent}%.1f</td></tr>"
    }
    val heads = Seq("unit", "mutants", "killed", "equivalent", "survive", "% killed").map(h => s"<th>$h</th>").mkString
    val alive = for ((unit, r) <- results; m <- r.survivors) yield s"<li>$unit $m</li>"
    Page(
      "Frustum: mutants",
      s"""<table><tr>$heads</tr>
         |${rows.mkString("\n")}</table>
         |<p>Per cent of those that are not shown to be equivalent to the unit.</p>
         |<ul>${alive.mkString("\n")}</ul>""".stripMargin
    )
  }
}
