package frustum.charts.systems

import frustum.boards.BoardTop
import frustum.boards.flow.{BitstreamReport, Ice40Flow, Ice40Tools, Nextpnr}
import frustum.BuildInfo
import frustum.files.{Digest, OutputFile}
import java.io.OutputStream
import java.nio.file.{Files, Path}
import scala.util.Try

/** What place and route made of a top.
  *
  * @param cells    logic cells of an iCE40; None of other parts
  * @param clockMHz slowest of the placements; None where the design does not fit its part
  * @param source   where the figures come from, in words
  */
final case class Placed(cells: Option[Int], clockMHz: Option[Double], source: String)

/** Clocks and sizes of tops, from earlier runs of place and route. Each is kept by the digest of its Verilog, so that a
  * figure is never that of other hardware.
  *
  * @param reports where `bitstream` leaves its reports, each beside the Verilog that it was made from
  * @param place   runs synthesis and placement of a top; None: what is not known stays unknown
  */
final class PlacedTops(
    place: Option[BoardTop => BitstreamReport],
    cache: Path = PlacedTops.Cache,
    reports: Path = PlacedTops.Reports
) extends (BoardTop => (Option[Placed], String)) {

  /** The figures of a top, and the digest of its Verilog. */
  def apply(top: BoardTop): (Option[Placed], String) = {
    val digest = PlacedTops.digest(verilog(top))
    val kept = PlacedTops.read(file(digest), s"${Nextpnr.Heap} placer, seed 1, kept in $cache")
    val found = kept.orElse(reported(top.name, digest)).orElse(place.flatMap { run =>
      OutputFile.writeText(file(digest), ujson.write(run(top).json(BuildInfo.version), indent = 2) + "\n")
      PlacedTops.read(file(digest), s"${Nextpnr.Heap} placer, seed 1")
    })
    (found, digest)
  }

  private def file(digest: String) = cache.resolve(s"placed-$digest.json")

  private def verilog(top: BoardTop): String = {
    val folder = OutputFile.folder(cache.resolve("work"))
    // SpinalHDL tells each of its steps.
    Console.withOut(OutputStream.nullOutputStream)(top.writeVerilog(folder.toString))
    Files.readString(folder.resolve(s"${top.name}.v"))
  }

  /** A report of `bitstream`, if it is of this very Verilog. */
  private def reported(name: String, digest: String): Option[Placed] = {
    val made = reports.resolve(s"$name.build").resolve(s"$name.v")
    if (Files.isRegularFile(made) && PlacedTops.digest(Files.readString(made)) == digest)
      PlacedTops.read(reports.resolve(s"$name.json"), s"report $name.json of `bitstream`")
    else None
  }
}

object PlacedTops {
  val Cache: Path = Path.of(".cache", "chart")
  val Reports: Path = Path.of("out", "bitstream")

  /** Places with one seed and nextpnr's own placer, which needs no half hour for any of these designs. */
  def flow(say: String => Unit): BoardTop => BitstreamReport = {
    lazy val tools = new Ice40Flow(Ice40Tools.find(say))
    top => {
      say(s"placing ${top.name}; this takes minutes and is kept")
      tools.run(top, Seq(1), OutputFile.folder(Cache.resolve("place")), say, Nextpnr.Heap)
    }
  }

  /** Of the Verilog without its comments, which name the commit. */
  def digest(verilog: String): String = {
    val text = verilog.linesIterator.filterNot(_.startsWith("//")).mkString("\n")
    Digest((text + Ice40Flow.Synthesis).getBytes("UTF-8"))
  }

  /** None where there is no report, or none that can be read. */
  def read(report: Path, source: String): Option[Placed] =
    if (!Files.isRegularFile(report)) None
    else
      Try {
        val r = ujson.read(Files.readString(report)).obj
        val clock = r.get("clockMHz").filter(_ => r("fits").bool).map(_("min").num)
        Placed(r.get("logicCells").map(_.num.toInt), clock, source)
      }.toOption
}
