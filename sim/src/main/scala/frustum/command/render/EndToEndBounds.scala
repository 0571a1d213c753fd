package frustum.command.render

import frustum.budgets.{Budget, BudgetTable, Measured}
import frustum.referee.EndToEnd
import java.nio.file.{Path, Paths}

/** What the referee's figures may be at worst, by the table in the tree: for a scene of `demo` in counts, for any other
  * picture as the share of pixels that no quantisation accounts for.
  *
  * Bounds are for float64's figures, which are the same on every machine. Those of llvmpipe are of the pixels at which
  * it agrees with float64, so they are no greater; how many those are is bounded by [[MostDiffer]].
  */
object EndToEndBounds {
  val Table: Path = Paths.get("sim", "budgets.json")

  /** Share of the judged pixels at which llvmpipe, whose numbers have 24 bits, may differ from float64, per cent;
    * measured: 0.
    */
  val MostDiffer = 0.5

  /** The figures of a scene as it is by default. */
  def ofScene(scene: String, e: EndToEndSum): Seq[Measured] = Seq(
    "primitiveWrong" -> e.world.primitiveWrong.toDouble,
    "texelsWrong" -> e.world.texelsWrong.toDouble,
    "primitiveUnexplained" -> e.world.primitiveUnexplained.toDouble,
    "texelsUnexplained" -> e.world.texelsUnexplained.toDouble,
    "colorWrong" -> e.world.colorWrong.toDouble,
    "psnr" -> e.worldDistance._1.getOrElse(Double.PositiveInfinity),
    "flip" -> e.worldDistance._2
  ).map { case (metric, value) => Measured(scene, s"endToEnd.$metric", value) }

  /** The figure of any other picture. */
  def ofAny(e: EndToEndSum): Seq[Measured] =
    Seq(Measured(Budget.AnyPicture, "endToEnd.unexplainedPercent", e.world.unexplainedPercent))

  /** What is worse than the table's bounds. */
  def failures(values: Seq[Measured], e: EndToEndSum, table: Path = Table): Seq[String] = {
    val check = BudgetTable.read(table).measured(values)
    val differ = 100.0 * e.counts.refereesDiffer / e.counts.judged.max(1)
    check.rows.filterNot(_.met).map(b =>
      s"end to end: ${b.metric.stripPrefix("endToEnd.")} is ${b.today}, its bound ${b.bound}"
    ) ++
      check.unbounded.map(m => s"end to end: ${m.metric} has no bound in $table") ++
      Option.when(e.counts.referee != EndToEnd.World && differ > MostDiffer)(
        f"end to end: llvmpipe and float64 differ in $differ%.2f %% of the judged pixels, at most $MostDiffer %% are " +
          "expected"
      )
  }
}
