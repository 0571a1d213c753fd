package frustum.command.demo

import frustum.command.common.{Page, ReportTable}
import java.nio.file.Path

/** The page of `demo`: one file with its pictures inside, so that it can be sent and kept. */
object DemoPage {

  /** @param folder where the scenes' PNG files are */
  def apply(folder: Path, reports: Seq[ujson.Obj]): String =
    s"""<!doctype html>
       |<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
       |<title>Frustum: the demo scenes</title>
       |<style>
       |:root { color-scheme: light dark; --ink: #1d2733; --soft: #62707f; --line: #d8dee6;
       |  --paper: #f5f7fa; --card: #fff }
       |@media (prefers-color-scheme: dark) {
       |  :root { --ink: #e4e9ef; --soft: #93a1b0; --line: #303a46; --paper: #12171d; --card: #1a2129 }
       |}
       |body { margin: 0 auto; padding: 2.5rem 1.5rem; max-width: 74rem; background: var(--paper);
       |  color: var(--ink); font: 16px/1.5 system-ui, sans-serif }
       |h1 { margin: 0; font-size: 2rem } h2 { margin: 0 0 1rem; text-transform: capitalize }
       |p { margin: .25rem 0 2rem; color: var(--soft) }
       |section { display: flex; flex-wrap: wrap; gap: 1.5rem; margin: 0 0 1.5rem; padding: 1.5rem;
       |  background: var(--card); border: 1px solid var(--line); border-radius: 12px }
       |section h2 { flex-basis: 100% }
       |figure { margin: 0 } figcaption { margin-top: .4rem; color: var(--soft); font-size: .85rem }
       |img { display: block; border-radius: 6px; image-rendering: pixelated; outline: 1px solid var(--line) }
       |dl { display: grid; grid-template-columns: auto auto; gap: .15rem 1.5rem; margin: 0;
       |  align-content: start; font-size: .9rem }
       |dt { color: var(--soft) } dd { margin: 0; text-align: right; font-variant-numeric: tabular-nums }
       |</style></head><body>
       |<h1>Frustum</h1>
       |<p>Every scene as the engine <b>${reports.headOption.fold("")(r =>
        r("engine").str
      )}</b> drew it, beside the float64
       |reference and the difference, eightfold, on white. Version ${frustum.BuildInfo.version}.</p>
       |${reports.map(section(folder, _)).mkString("\n")}
       |</body></html>
       |""".stripMargin

  private def section(folder: Path, report: ujson.Obj): String = {
    val scene = report("scene").str
    val size = s"""width="${report("width").num.toInt}" height="${report("height").num.toInt}""""
    val pictures = Seq("" -> "picture", ".reference" -> "reference", ".difference" -> "difference").map {
      case (kind, caption) =>
        val data = Page.source(folder.resolve(s"$scene$kind.png"))
        val image = s"""<img $size alt="$scene: $caption" src="$data">"""
        s"<figure>$image<figcaption>$caption</figcaption></figure>"
    }
    val figures =
      ReportTable.columns.map { case (heading, show) => heading -> show(report) }.filter(_._2 != "-")
        .map { case (heading, figure) => s"<dt>${heading.replace("!=", "&ne;")}</dt><dd>$figure</dd>" }
    s"<section><h2>$scene</h2>\n${pictures.mkString("\n")}\n<dl>${figures.mkString}</dl></section>"
  }
}
