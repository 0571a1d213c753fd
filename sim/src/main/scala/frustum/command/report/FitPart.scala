package frustum.command.report

import frustum.command.common.{Figure, Page}

/** Hardware that `fit` made no larger than a scene needs. */
object FitPart extends ReportPart("Hardware fitted to a scene", "fit", "fit --scene cube --texels-wrong 0.5") {
  def shown(files: ReportFiles): Option[Shown] = {
    val fits = files.ofKind(".json").map(f =>
      files.read(f)(r => (cells(f.getFileName.toString.stripSuffix(".json"), r), r("met").bool))
    )
    Option.when(fits.nonEmpty)(
      Shown(
        s"<section>${Page.table(Head, fits.map(_._1), n => !fits(n)._2)}</section>",
        s"${fits.count(_._2)} of ${fits.length} within their budget",
        fits.forall(_._2),
        files.ofKind(".json") ++ files.ofKind(".html")
      )
    )
  }

  private val Head =
    Seq("scene", "logic cells", "of the full preset", "MHz", "held-out views", "of these over budget", "verdict")

  private def cells(stem: String, r: ujson.Obj): Seq[String] = {
    def figure(key: String) = r.value.get(key).flatMap(_.numOpt).fold("")(Figure(_))
    val keys = Seq("logicCells", "fullPresetLogicCells", "clockMHz", "heldOutViews", "heldOutOverBudget")
    val verdict = if (r("met").bool) "<span class=\"good\">met</span>" else "<b class=\"bad\">missed</b>"
    (Page.escape(stem) +: keys.map(figure)) :+ verdict
  }
}
