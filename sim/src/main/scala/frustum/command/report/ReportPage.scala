package frustum.command.report

import frustum.command.common.Page

/** A part as it goes onto the page.
  *
  * @param made  when its newest file was written
  * @param links name and place beside the page
  */
final case class MadePart(part: ReportPart, shown: Option[Shown], made: String, links: Seq[(String, String)])

/** The page of `report`. */
object ReportPage {
  def apply(parts: Seq[MadePart], version: String): String = Page(
    "Frustum: report",
    s"""<p class="soft">3-D graphics hardware for small FPGAs: pictures, accuracy, speed and size, as far as they have
       |been measured here. Version $version. Pictures and figures lie inside this page; the links need the folder
       |<code>data</code> beside it.</p>
       |<section>${Page.table(Seq("part", "result", "made", "by"), parts.map(row))}</section>
       |${parts.filter(_.shown.isDefined).map(section).mkString("\n")}""".stripMargin
  )

  private def row(p: MadePart): Seq[String] = p.shown match {
    case Some(s) =>
      val kind = if (s.good) "good" else "bad"
      Seq(
        s"""<a href="#${p.part.folder}">${p.part.title}</a>""",
        s"""<span class="$kind">${Page.escape(s.verdict)}</span>""",
        s"<span>${p.made}</span>",
        call(p.part)
      )
    case None => Seq(p.part.title, "<span class=\"soft\">not run yet</span>", "", s"make it: ${call(p.part)}")
  }

  private def section(p: MadePart): String = {
    val links = p.links.map { case (name, place) => s"""<a href="${Page.escape(place)}">${Page.escape(name)}</a>""" }
    s"""<h2 id="${p.part.folder}">${p.part.title}</h2>
       |${p.shown.get.html}
       |<p class="soft">Files: ${links.mkString(", ")}</p>""".stripMargin
  }

  private def call(part: ReportPart) = {
    val line = if (part.command.contains(' ')) s"\"${part.command}\"" else part.command
    s"<code>./sbt ${Page.escape(line)}</code>"
  }
}
