package frustum.command.report

import frustum.command.common.{Figure, Page}
import java.nio.file.Path

/** The charts in one folder, those that were charted alone included. */
final class ChartsPart(title: String, folder: String, command: String) extends ReportPart(title, folder, command) {
  def shown(files: ReportFiles): Option[Shown] = {
    val pictures = files.ofKind(".png")
    val charts = files.ofKind(".json").flatMap(f => files.read(f)(_("charts").arr.map(c => c("name").str -> c).toSeq))
    val (told, order) = (charts.toMap, charts.map(_._1))
    Option.when(pictures.nonEmpty)(
      Shown(
        pictures.sortBy(p => (order.indexOf(name(p)) + 1, name(p))).map(figure(_, told))
          .mkString("<section>", "\n", "</section>"),
        s"${pictures.length} charts",
        good = true,
        pictures ++ Seq(".csv", ".json", ".html").flatMap(files.ofKind)
      )
    )
  }

  private def name(picture: Path) = picture.getFileName.toString.stripSuffix(".png")

  private def figure(picture: Path, told: Map[String, ujson.Value]): String = {
    def of(key: String) = told.get(name(picture)).flatMap(_.obj.get(key)).map(_.str)
    val title = of("title").getOrElse(Figure.words(name(picture).replace('-', ' ')))
    val axes = for (cost <- of("costAxis"); error <- of("errorAxis")) yield s"Upwards: $error; to the right: $cost."
    val note = (axes ++ of("note")).map(Page.escape).mkString(" ")
    s"""<figure><img alt="${Page.escape(title)}" src="${Page.source(picture)}">
       |<figcaption><b>${Page.escape(title)}.</b> $note</figcaption></figure>""".stripMargin
  }
}
