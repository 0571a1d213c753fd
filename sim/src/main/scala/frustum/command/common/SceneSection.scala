package frustum.command.common

import java.nio.file.Path

/** A scene on a page: its pictures in a row, all of one height, and the figures of its report. */
object SceneSection {

  /** Pixels on the screen. */
  val Height = 320

  /** @param pictures files, and what each shows
    * @param report as `render`, `pong`, `voxel` and `demo` write it
    */
  def apply(title: String, pictures: Seq[(Path, String)], report: ujson.Obj): String = {
    val (width, height) = (report("width").num.toInt, report("height").num.toInt)
    val figures =
      for (c <- ReportTable.columns; figure = c.show(report) if figure != "-") yield (heading(c), figure, c.meaning)
    s"""<section><h2>${Page.escape(title)}</h2>
       |<div class="pictures">
       |${pictures.map { case (file, caption) => picture(file, title, caption, width, height) }.mkString("\n")}
       |</div>
       |${Page.figures(figures)}</section>""".stripMargin
  }

  /** What the figures mean that these reports have. */
  def legend(reports: Seq[ujson.Obj]): String =
    s"""<section><h2>What the figures mean</h2>
       |${Page.legend(ReportTable.shown(reports).map(c => heading(c) -> c.meaning))}</section>""".stripMargin

  /** Pixels keep their edges where each becomes a whole number of the screen's. */
  private def picture(file: Path, title: String, caption: String, width: Int, height: Int): String = {
    val shown = (width.toDouble * Height / height).round
    val pixels = if (Height % height == 0) " class=\"pixels\"" else ""
    val says = Page.escape(s"$title: $caption")
    s"""<figure style="width: ${shown}px"><img$pixels width="$shown" height="$Height" alt="$says"
       |src="${Page.source(file)}"><figcaption>${Page.escape(caption)}</figcaption></figure>""".stripMargin
  }

  private def heading(c: ReportTable.Column) = c.heading.replace("!=", "&ne;")
}
