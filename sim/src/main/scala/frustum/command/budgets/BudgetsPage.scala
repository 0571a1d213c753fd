package frustum.command.budgets

import frustum.budgets.{Budget, Metric}
import frustum.command.common.{Figure, Page}

/** The page of `budgets`: each figure by its name, with its unit, its bound and a verdict, scene by scene. */
object BudgetsPage {

  /** @param failures lines that say what is wrong, as on the terminal */
  def apply(rows: Seq[Budget], failures: Seq[String]): String =
    Page("Frustum: budgets", s"${verdict(rows, failures)}\n${tables(rows)}")

  /** How many bounds are kept, and what else is wrong. */
  def verdict(rows: Seq[Budget], failures: Seq[String]): String = {
    val missed = rows.count(!_.met)
    // Figures without a bound, and bounds without a figure.
    val others = failures.filterNot(rows.filterNot(_.met).map(_.toString).contains(_))
    val kind = if (missed == 0 && others.isEmpty) "good" else "bad"
    val told = others.map(f => s"<p class=\"bad\">${Page.escape(f)}</p>").mkString("\n")
    s"""<p>Each figure is measured on the bit-exact model, which the hardware equals, and may not be worse than its
       |bound. <b class="$kind">${rows.length - missed} of ${rows.length} bounds are met.</b></p>
       |$told""".stripMargin
  }

  def tables(rows: Seq[Budget]): String = rows.map(_.scene).distinct.map { scene =>
    val own = rows.filter(_.scene == scene)
    s"<section><h2>$scene</h2>\n${Page.table(Head, own.map(cells), n => !own(n).met)}</section>"
  }.mkString("\n")

  private val Head = Seq("figure", "today", "bound", "unit", "verdict")

  private def cells(b: Budget): Seq[String] = {
    val metric = Metric.of(b.metric)
    val direction = if (b.higherIsBetter) "at least" else "at most"
    Seq(
      metric.name,
      if (b.met) value(b.today) else value(b.today, digits = 12),
      if (b.bound.isInfinite) "pictures equal" else s"$direction ${value(b.bound)}",
      metric.unit,
      if (b.met) "<span class=\"good\">met</span>" else "<b class=\"bad\">missed</b>"
    )
  }

  /** A digit more than bounds have. */
  private def value(v: Double, digits: Int = 6) = if (v.isInfinite) "pictures equal" else Figure(v, digits)
}
