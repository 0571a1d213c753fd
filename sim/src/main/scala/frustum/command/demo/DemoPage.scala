package frustum.command.demo

import frustum.command.common.{Page, SceneSection}
import java.nio.file.{Files, Path}

/** The page of `demo`: one file with its pictures inside. */
object DemoPage {

  /** @param folder where the scenes' pictures are */
  def apply(folder: Path, reports: Seq[ujson.Obj]): String = Page(
    "Frustum: the demo scenes",
    s"""<p class="soft">Every scene as the engine <b>${reports.headOption.fold("")(_("engine").str)}</b> drew it, beside
       |the float64 reference and the difference of the two, eightfold, on white. Version
       |${frustum.BuildInfo.version}.</p>
       |${body(folder, reports)}""".stripMargin
  )

  /** The scenes, one after the other, and what their figures mean. */
  def body(folder: Path, reports: Seq[ujson.Obj]): String = {
    val scenes = reports.map(r => SceneSection(r("scene").str, pictures(folder, r), r))
    (scenes :+ SceneSection.legend(reports)).mkString("\n")
  }

  /** The pictures of a scene that there are, and what each shows. */
  def pictures(folder: Path, report: ujson.Obj): Seq[(Path, String)] = Seq(
    ".png" -> s"drawn by engine ${report("engine").str}",
    ".reference.png" -> "reference: exact arithmetic or float64, in the board's colours",
    ".difference.png" -> "difference from the reference, eightfold",
    ".referee.png" -> s"referee ${report.value.get("endToEnd").fold("")(_("referee").str)}, from the user's input",
    ".gif" -> "the game as it moves"
  ).collect {
    case (kind, caption) if Files.isRegularFile(file(folder, report, kind)) => file(folder, report, kind) -> caption
  }

  private def file(folder: Path, report: ujson.Obj, kind: String) = folder.resolve(s"${report("scene").str}$kind")
}
