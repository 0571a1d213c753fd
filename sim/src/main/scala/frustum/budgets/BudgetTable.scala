package frustum.budgets

import frustum.contract.InputError
import frustum.files.{InfinityAsNull, JsonFile, OutputFile}
import java.nio.file.Path
import scala.util.control.NonFatal

/** The table of budgets as it lies in the tree: JSON, scene by scene, `{"bound", "today"}` for each metric; null is
  * infinite.
  */
final case class BudgetTable(rows: Seq[Budget]) {
  private val byKey = rows.map(b => (b.scene, b.metric) -> b).toMap

  /** With new values: rows that are not measured any more, and values without a row, are told of. */
  def measured(values: Seq[Measured]): BudgetCheck = {
    val found = values.flatMap(m => byKey.get((m.scene, m.metric)).map(_.measured(m.value)))
    BudgetCheck(
      found,
      unbounded = values.filterNot(m => byKey.contains((m.scene, m.metric))),
      unmeasured = rows.filterNot(b => values.exists(m => (m.scene, m.metric) == ((b.scene, b.metric))))
    )
  }

  def write(file: Path): Unit = {
    val scenes = rows.map(_.scene).distinct.map { scene =>
      val own = rows.filter(_.scene == scene)
      scene -> ujson.Obj.from(own.map(b =>
        b.metric -> ujson.Obj(
          "bound" -> InfinityAsNull.write(b.bound),
          "today" -> InfinityAsNull.write(b.today)
        )
      ))
    }
    OutputFile.writeText(file, ujson.write(ujson.Obj.from(scenes), indent = 2) + "\n")
  }
}

object BudgetTable {
  def read(file: Path): BudgetTable = {
    try BudgetTable(
        for {
          (scene, metrics) <- JsonFile.read(file, "sim/budgets.json of the repository").root.obj.toSeq
          (metric, figures) <- metrics.obj.toSeq
        } yield Budget(
          scene,
          metric,
          InfinityAsNull.read(figures("bound")),
          InfinityAsNull.read(figures("today"))
        )
      )
    catch {
      case e: InputError => throw e
      case NonFatal(e)   =>
        throw InputError(
          s"$file: is no table of budgets (${e.getMessage.linesIterator.next()}); restore it from the repository"
        )
    }
  }
}

/** A figure of a scene. */
final case class Measured(scene: String, metric: String, value: Double)

/** A table held against new values. */
final case class BudgetCheck(rows: Seq[Budget], unbounded: Seq[Measured], unmeasured: Seq[Budget]) {

  /** What is worse than its bound, or has none, or is bounded and not measured. */
  def failures: Seq[String] =
    rows.filterNot(_.met).map(_.toString) ++
      unbounded.map(m => s"${m.scene}: ${m.metric} has no bound; give it one with budgets --update") ++
      unmeasured.map(b => s"${b.scene}: ${b.metric} has a bound and is not measured; remove its row")

  /** Bounds only ever become tighter; new figures get theirs. What is worse than its bound stays so. */
  def updated: BudgetTable =
    BudgetTable(rows.map(_.tightened) ++ unbounded.map(m =>
      Budget.first(m.scene, m.metric, m.value)
    ) ++ unmeasured)
}
