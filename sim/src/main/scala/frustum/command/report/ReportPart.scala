package frustum.command.report

import java.nio.file.Path

/** What the report shows of a command.
  *
  * @param html    the part of the page
  * @param verdict in a few words
  * @param good    whether all is as it should be
  * @param files   that go with the page
  */
final case class Shown(html: String, verdict: String, good: Boolean, files: Seq[Path])

/** A part of the report's page: what one command leaves in its folder of `out`.
  *
  * @param folder  of the command
  * @param command that makes it, as it is written after ./sbt
  */
abstract class ReportPart(val title: String, val folder: String, val command: String) {

  /** None where the command has not been run. */
  def shown(files: ReportFiles): Option[Shown]
}

object ReportPart {
  val all: Seq[ReportPart] = Seq(
    DemoPart,
    new ChartsPart("Whole systems: speed against accuracy", "chart/systems", "chart systems"),
    new ChartsPart("Accuracy against cost", "chart", "chart"),
    StabilityPart,
    BudgetsPart,
    BenchPart,
    BitstreamsPart,
    FitPart,
    MutatePart,
    new PicturesPart("Scenes drawn one by one", "render", "render --scene teapot"),
    new PicturesPart("Pong", "pong", "pong --autoplay"),
    new PicturesPart("Worlds of blocks", "voxel", "voxel")
  )
}
