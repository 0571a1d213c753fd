package frustum.command.common

import java.nio.file.{Files, Path}
import java.util.Base64

/** A page of the workbench: one HTML file with everything it shows inside, so that it can be sent and kept. */
object Page {

  /** A picture (PNG or GIF) as the source of an image within the page. */
  def source(picture: Path): String = {
    val kind = if (picture.toString.endsWith(".gif")) "gif" else "png"
    s"data:image/$kind;base64,${Base64.getEncoder.encodeToString(Files.readAllBytes(picture))}"
  }

  /** A chart within the page, whose data and picture of shapes lie beside it.
    *
    * @param picture a PNG, with an SVG of its name
    * @param data    name of the CSV
    */
  def chart(title: String, picture: Path, note: String, data: String): String = {
    val shapes = picture.getFileName.toString.stripSuffix(".png") + ".svg"
    s"""<figure><img alt="$title" src="${source(picture)}">
       |<figcaption>$note Data: $data;
       |the same picture as $shapes.</figcaption></figure>""".stripMargin
  }

  /** Text that may hold what HTML takes for its own. */
  def escape(text: String): String =
    text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")

  /** @param rows cells of HTML, as many in each as in the head; columns of numbers are set to the right
    * @param over  rows that are marked as missing their bound
    */
  def table(head: Seq[String], rows: Seq[Seq[String]], over: Int => Boolean = _ => false): String = {
    val numbers = head.indices.map(i => rows.forall(_(i).headOption.forall(_.isDigit)))
    def line(tag: String, cells: Seq[String]) = cells.zip(numbers).map { case (c, number) =>
      s"<$tag${if (number) " class=\"number\"" else ""}>$c</$tag>"
    }.mkString
    val lines = rows.zipWithIndex.map { case (cells, n) =>
      s"<tr${if (over(n)) " class=\"over\"" else ""}>${line("td", cells)}</tr>"
    }
    s"""<div class="wide"><table><tr>${line("th", head)}</tr>
       |${lines.mkString("\n")}
       |</table></div>""".stripMargin
  }

  /** Figures by name: name and value, HTML, and what the name means. */
  def figures(named: Seq[(String, String, String)]): String = named.map { case (name, value, meaning) =>
    s"""<div title="${escape(meaning)}"><dt>$name</dt><dd>$value</dd></div>"""
  }.mkString("<dl class=\"figures\">", "\n", "</dl>")

  /** What the names of figures mean. */
  def legend(named: Seq[(String, String)]): String =
    named.map { case (name, meaning) => s"<dt>$name</dt><dd>$meaning</dd>" }.mkString(
      "<dl class=\"legend\">",
      "\n",
      "</dl>"
    )

  def apply(title: String, body: String): String =
    s"""<!doctype html>
       |<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
       |<title>$title</title>
       |<style>
       |$style
       |</style></head><body>
       |<h1>$title</h1>
       |$body
       |</body></html>
       |""".stripMargin

  private val style =
    """:root { color-scheme: light dark; --ink: #1d2733; --soft: #5c6977; --line: #d8dee6;
      |  --paper: #f5f7fa; --card: #fff; --good: #1d7a45; --bad: #b42318 }
      |@media (prefers-color-scheme: dark) {
      |  :root { --ink: #e4e9ef; --soft: #9aa7b5; --line: #303a46; --paper: #12171d; --card: #1a2129;
      |    --good: #5fce8f; --bad: #ff8f85 }
      |}
      |body { margin: 0 auto; padding: 2.5rem 1.5rem; max-width: 74rem; background: var(--paper);
      |  color: var(--ink); font: 16px/1.5 system-ui, sans-serif }
      |h1 { margin: 0 0 1rem; font-size: 2rem } h2 { margin: 0 0 1rem } h3 { margin: 1.5rem 0 .5rem }
      |p { margin: .25rem 0 1rem } a { color: inherit } code { font-size: .9em }
      |.soft, figcaption { color: var(--soft) } .good { color: var(--good) } .bad { color: var(--bad) }
      |section { margin: 0 0 1.5rem; padding: 1.5rem; background: var(--card);
      |  border: 1px solid var(--line); border-radius: 12px }
      |.wide { overflow-x: auto; margin: 0 0 1rem }
      |table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums }
      |th { text-align: left; color: var(--soft); font-weight: 600 }
      |th, td { padding: .25rem 1.25rem .25rem 0; border-bottom: 1px solid var(--line); vertical-align: top }
      |.number { text-align: right } tr.over { background: #e334 }
      |figure { margin: 1rem 0 } figcaption { margin-top: .4rem; font-size: .85rem }
      |img { display: block; max-width: 100%; border-radius: 6px; outline: 1px solid var(--line) }
      |.pictures { display: flex; flex-wrap: wrap; gap: 1rem } .pictures figure { margin: 0 }
      |.pixels { image-rendering: pixelated }
      |.figures { display: flex; flex-wrap: wrap; gap: .5rem 2rem; margin: 1rem 0 0; font-size: .9rem }
      |.figures dt { color: var(--soft) } .figures dd { margin: 0; font-variant-numeric: tabular-nums }
      |.legend { display: grid; grid-template-columns: max-content 1fr; gap: .3rem 1.5rem; margin: 0;
      |  font-size: .9rem } .legend dt { font-weight: 600 } .legend dd { margin: 0 }
      |@media (max-width: 40rem) { .legend { grid-template-columns: 1fr } }
      |@media (max-width: 40rem) { .legend dd { margin: 0 0 .5rem } }""".stripMargin
}
