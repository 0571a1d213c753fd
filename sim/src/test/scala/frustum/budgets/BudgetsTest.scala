package frustum.budgets

import frustum.command.budgets.BudgetMeasures
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Paths}

/** Today's figures against the bounds of the tree, and the rules by which bounds move. */
class BudgetsTest extends AnyFunSuite {
  private lazy val table = BudgetTable.read(Paths.get("sim", "budgets.json"))

  for (scene <- BudgetMeasures.scenes) test(s"$scene keeps its budgets") {
    val own = BudgetTable(table.rows.filter(_.scene == scene))
    assert(own.rows.nonEmpty)
    assert(own.measured(BudgetMeasures(scene)).failures.isEmpty)
  }

  test("every row is of a scene that is measured") {
    assert(table.rows.map(_.scene).toSet == BudgetMeasures.scenes.toSet)
  }

  private val three = BudgetTable(Seq(
    Budget("a", "wrong", bound = 5, today = 5),
    Budget("a", "psnr", bound = 40, today = 41),
    Budget("b", "wrong", bound = 0, today = 0)
  ))

  test("a worse value fails, and an update does not loosen its bound") {
    val check =
      three.measured(Seq(Measured("a", "wrong", 6), Measured("a", "psnr", 39.5), Measured("b", "wrong", 0)))
    assert(check.failures.length == 2)
    assert(check.updated.rows.map(_.bound) == Seq(5, 40, 0))
    assert(check.updated.rows.count(!_.met) == 2)
  }

  test("an update tightens to a better value, rounded on the safe side") {
    val check = three.measured(Seq(
      Measured("a", "wrong", 2.3456789),
      Measured("a", "psnr", 43.456789),
      Measured("b", "wrong", 0)
    ))
    assert(check.failures.isEmpty)
    assert(check.updated.rows.map(_.bound) == Seq(2.3457, 43.456, 0))
    assert(check.updated.rows.forall(_.met))
  }

  test("a figure without a bound and a bound without a figure fail") {
    val check =
      three.measured(Seq(Measured("a", "wrong", 5), Measured("a", "psnr", 41), Measured("c", "wrong", 0)))
    assert(check.failures.length == 2)
    assert(check.failures.exists(_.contains("c: wrong")) && check.failures.exists(_.contains("b: wrong")))
  }

  test("a table is read as it was written, equal pictures among it") {
    val file = Files.createTempFile("budgets", ".json")
    val rows = three.rows :+ Budget("c", "psnr", Double.PositiveInfinity, Double.PositiveInfinity)
    BudgetTable(rows).write(file)
    assert(BudgetTable.read(file).rows == rows)
  }
}
