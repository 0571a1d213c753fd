package frustum.command.report

import frustum.command.common.SceneSection
import java.nio.file.Path

/** Pictures of a command that draws, each with the figures of its report. */
final class PicturesPart(title: String, folder: String, command: String) extends ReportPart(title, folder, command) {
  def shown(files: ReportFiles): Option[Shown] = {
    val drawn = for {
      file <- files.ofKind(".json")
      stem = file.getFileName.toString.stripSuffix(".json")
      picture <- Seq(".gif", ".png", "-0.png").flatMap(kind => files.find(stem + kind)).headOption
    } yield files.read(file)(report => (section(stem, picture, report), report, Seq(file, picture)))
    Option.when(drawn.nonEmpty)(
      Shown(
        (drawn.map(_._1) :+ SceneSection.legend(drawn.map(_._2))).mkString("\n"),
        s"${drawn.length} drawn",
        good = true,
        drawn.flatMap(_._3)
      )
    )
  }

  private def section(stem: String, picture: Path, report: ujson.Obj) =
    SceneSection(stem, Seq(picture -> s"drawn by engine ${report("engine").str}"), report)
}
