package frustum.command.report

import frustum.budgets.Budget
import frustum.command.budgets.BudgetsPage
import frustum.files.InfinityAsNull

/** The bounds of `budgets`. */
object BudgetsPart extends ReportPart("Budgets of accuracy", "budgets", "budgets") {
  def shown(files: ReportFiles): Option[Shown] = files.find("budgets.json").map(file =>
    files.read(file) { report =>
      val rows = report("budgets").arr.toSeq.map(b =>
        Budget(b("scene").str, b("metric").str, InfinityAsNull.read(b("bound")), InfinityAsNull.read(b("today")))
      )
      val failures = report("failures").arr.map(_.str).toSeq
      Shown(
        BudgetsPage.verdict(rows, failures) + BudgetsPage.tables(rows),
        s"${rows.count(_.met)} of ${rows.length} bounds are met",
        failures.isEmpty,
        Seq(file) ++ files.find("budgets.csv") ++ files.find("index.html")
      )
    }
  )
}
