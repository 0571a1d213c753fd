package frustum.command.report

import frustum.BuildInfo
import frustum.command.common.{Arguments, CommandLine, Progress}
import frustum.contract.InputError
import frustum.files.OutputFile
import scopt.OParser
import java.nio.file.{Files, Path, Paths, StandardCopyOption}
import java.time.format.DateTimeFormatter
import java.time.{Instant, ZoneId}

/** Arguments of `report`. */
final case class ReportOptions(from: Path = Paths.get("out"), out: Path = Paths.get("out", "report"))

/** `report`: what the other commands left in `out`, on one page. What has not been run is named with its command. */
object ReportCommand extends CommandLine {
  val name = "report"
  val summary = "brings all results together on one page to send: out/report/index.html"

  private val parser: OParser[_, ReportOptions] = {
    val builder = OParser.builder[ReportOptions]
    import builder._
    OParser.sequence(
      programName("./sbt report"),
      head(s"report: $summary"),
      opt[Path]("from")(Arguments.file).valueName("DIR").action((v, o) => o.copy(from = v))
        .text("where the commands' folders are (default out)"),
      opt[Path]("out")(Arguments.file).valueName("DIR").action((v, o) => o.copy(out = v)).text("(default out/report)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, ReportOptions()).fold(0)(report)

  private def report(o: ReportOptions): Int = {
    val page = o.out.resolve("index.html")
    if (same(o.from, data(o))) throw InputError(
      s"--from ${o.from}: is where the report keeps its copies; name the folder that the commands write to, such as out"
    )
    OutputFile.check(page)
    val progress = Progress(name, ReportPart.all.length)
    val parts =
      try ReportPart.all.map { part =>
          val made = make(o, part)
          progress.step()
          made
        }
      finally progress.close()
    OutputFile.writeText(page, ReportPage(parts, BuildInfo.version))
    val missing = parts.filter(_.shown.isEmpty).map(_.part)
    println(s"wrote $page, ${parts.length - missing.length} of ${parts.length} parts")
    missing.foreach(p => println(s"not run yet: ./sbt \"${p.command}\""))
    0
  }

  /** What the page does not show itself. */
  private def linked(file: String) = Seq(".json", ".csv", ".html").exists(file.endsWith)

  /** Copies of what the page shows. */
  private def data(o: ReportOptions) = o.out.resolve("data")

  private def same(a: Path, b: Path) = a.toAbsolutePath.normalize == b.toAbsolutePath.normalize

  private def make(o: ReportOptions, part: ReportPart): MadePart = {
    val shown = part.shown(new ReportFiles(o.from.resolve(part.folder), part.command))
    val files = shown.toSeq.flatMap(_.files).distinct
    val beside = data(o).resolve(part.folder)
    clear(beside)
    for (file <- files)
      OutputFile.write(beside.resolve(file.getFileName))(Files.copy(file, _, StandardCopyOption.REPLACE_EXISTING))
    val newest = files.map(Files.getLastModifiedTime(_).toInstant).maxOption
    MadePart(
      part,
      shown,
      newest.fold("")(day),
      files.map(_.getFileName.toString).filter(linked).map(f => f -> s"data/${part.folder}/$f")
    )
  }

  /** Without what an earlier report left. */
  private def clear(folder: Path): Unit =
    Option(folder.toFile.listFiles).toSeq.flatten.filter(_.isFile).foreach(_.delete())

  private def day(at: Instant): String =
    DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm").withZone(ZoneId.systemDefault).format(at)
}
