package frustum.command.budgets

import frustum.budgets.{Budget, BudgetTable, Metric}
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Paths

class BudgetsPageTest extends AnyFunSuite {
  private val rows = BudgetTable.read(Paths.get("sim", "budgets.json")).rows
  private val page = BudgetsPage(rows, Nil)

  test("every figure of the table has a name") {
    for (row <- rows) assert(Metric.all.exists(_.key == row.metric), row.metric)
  }

  test("no key and no number of more than six digits is shown") {
    for (key <- rows.map(_.metric).distinct if key.exists(c => c.isUpper || c == '.'))
      assert(!page.contains(s">$key<"), key)
    val numbers = "(?<![-#\\w.])\\d[\\d,]*\\.\\d+".r.findAllIn(page.dropWhile(_ != '\n').split("</style>").last).toSeq
    assert(numbers.nonEmpty)
    for (n <- numbers) assert(n.filter(_.isDigit).dropWhile(_ == '0').length <= 6, n)
  }

  test("direction and verdict") {
    val two =
      Seq(Budget("a", "psnr", bound = 40, today = 39.99999), Budget("a", "maxColourError", bound = 1, today = 0.5))
    val shown = BudgetsPage(two, two.take(1).map(_.toString) :+ "b: swim has no bound")
    assert(shown.contains("at least 40") && shown.contains("at most 1") && shown.contains("of 255"))
    assert(shown.contains("39.99999"), "the value that misses")
    assert(
      shown.contains("missed") && shown.contains("1 of 2 bounds are met") && shown.contains("b: swim has no bound")
    )
    assert(shown.split("missed").length == 2)
  }
}
