package frustum.command.report

import frustum.command.common.{Figure, Page}

/** The map of `stability`, and each method's domain with the worst error found in it. */
object StabilityPart extends ReportPart("Where methods fail", "stability", "stability") {
  def shown(files: ReportFiles): Option[Shown] = files.find("stability.json").map(file =>
    files.read(file) { report =>
      val sweeps = report("sweeps").arr.toSeq
      val failures = report("failures").arr.map(_.str).toSeq
      val map = files.find("map.png")
      val picture = map.fold("")(p => s"""<figure><img alt="where methods fail" src="${Page.source(p)}"></figure>""")
      Shown(
        s"""<section>$picture
           |${failures.map(f => s"<p class=\"bad\">${Page.escape(f)}</p>").mkString("\n")}
           |${Page.table(Head, sweeps.map(cells))}</section>""".stripMargin,
        if (failures.isEmpty) s"all ${sweeps.length} within their declared bounds"
        else s"${failures.length} beyond their bounds",
        failures.isEmpty,
        Seq(file) ++ map ++ files.find("stability.csv") ++ files.find("index.html")
      )
    }
  )

  private val Head =
    Seq("method", "what it depends on", "declared for", "worst error there", "bound", "unit of the error")

  private def cells(s: ujson.Value): Seq[String] = {
    val domain = s("validFor")
    Seq(
      Page.escape(s("method").str),
      Page.escape(s"${s("quantity").str}, ${s("unit").str}"),
      s"${Figure(domain("low").num)} to ${Figure(domain("high").num)}",
      if (s("worst").isNull) "none" else Figure(s("worst").num),
      Figure(s("bound").num),
      Page.escape(s("errorUnit").str)
    )
  }
}
