package frustum.command.budgets

import frustum.budgets.{Budget, BudgetTable}
import frustum.BuildInfo
import frustum.command.common.{Arguments, CommandLine, Progress}
import frustum.files.{InfinityAsNull, OutputFile}
import scopt.OParser
import java.nio.file.{Path, Paths}

/** Arguments of `budgets`. */
final case class BudgetsOptions(
    update: Boolean = false,
    table: Path = Paths.get("sim", "budgets.json"),
    out: Path = Paths.get("out", "budgets")
)

/** `budgets`: every scene's figures against the bounds of the table in the tree. */
object BudgetsCommand extends CommandLine {
  val name = "budgets"
  val summary = "measures every scene against its bounds in sim/budgets.json; writes out/budgets"

  private val parser: OParser[_, BudgetsOptions] = {
    val builder = OParser.builder[BudgetsOptions]
    import builder._
    OParser.sequence(
      programName("./sbt budgets"),
      head(s"budgets: $summary"),
      opt[Unit]("update").action((_, o) => o.copy(update = true))
        .text("tightens bounds to what was measured and gives new figures one; never loosens any"),
      opt[Path]("table")(Arguments.file).valueName("FILE.json").action((v, o) => o.copy(table = v))
        .text("(default sim/budgets.json)"),
      opt[Path]("out")(
        Arguments.file
      ).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/budgets)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, BudgetsOptions()).fold(0)(budgets)

  private def budgets(o: BudgetsOptions): Int = {
    val table = BudgetTable.read(o.table)
    val progress = Progress(name, BudgetMeasures.scenes.length)
    val values =
      try BudgetMeasures.scenes.flatMap { scene =>
          val v = BudgetMeasures(scene); progress.step(); v
        }
      finally progress.close()
    val check = table.measured(values)
    val shown = if (o.update) check.updated else BudgetTable(check.rows)
    if (o.update) shown.write(o.table)
    val failures = if (o.update) check.rows.filterNot(_.met).map(_.toString) else check.failures
    write(o.out, shown.rows, failures)
    println(
      s"${shown.rows.count(_.met)} of ${shown.rows.length} budgets are met; wrote ${o.out.resolve("index.html")}"
    )
    if (o.update) println(s"wrote ${o.table}")
    failures.foreach(f => Console.err.println(s"error: budgets: $f"))
    if (failures.isEmpty) 0 else 1
  }

  private def write(out: Path, rows: Seq[Budget], failures: Seq[String]): Unit = {
    def text(v: Double) = if (v.isInfinite) "equal" else BigDecimal(v).toString
    val csv = "scene,metric,bound,today,met" +: rows.map(b =>
      Seq(b.scene, b.metric, text(b.bound), text(b.today), b.met.toString).mkString(",")
    )
    val report = ujson.Obj(
      "command" -> name,
      "version" -> BuildInfo.version,
      "seed" -> 1,
      "engine" -> "model",
      "met" -> failures.isEmpty,
      "failures" -> failures,
      "budgets" -> rows.map(b =>
        ujson.Obj(
          "scene" -> b.scene,
          "metric" -> b.metric,
          "bound" -> InfinityAsNull.write(b.bound),
          "today" -> InfinityAsNull.write(b.today),
          "met" -> b.met
        )
      )
    )
    OutputFile.writeText(out.resolve("budgets.csv"), csv.mkString("", "\n", "\n"))
    OutputFile.writeText(out.resolve("budgets.json"), ujson.write(report, indent = 2) + "\n")
    OutputFile.writeText(out.resolve("index.html"), BudgetsPage(rows, failures))
  }
}
