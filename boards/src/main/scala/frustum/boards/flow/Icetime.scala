package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path}

/** A second timing analysis, by icestorm's analyser, which shares no delay model with nextpnr. */
object Icetime {

  /** MHz of the critical path of `<name>.<seed>.asc` over all clocks and pins, or None where no icetime works: several
    * are tried, as one without its chip database fails.
    */
  def analyse(tools: Seq[Tool], directory: Path, top: BoardTop, seed: Int): Option[Double] = {
    val arguments = Seq("-d", "up5k", "-P", top.part.packageName, "-c", s"${top.targetMHz}", s"${top.name}.$seed.asc")
    tools.iterator.map { tool =>
      val log = s"${top.name}.$seed.icetime.log"
      tool.run(directory, log, arguments)
      estimate(Files.readString(directory.resolve(log)))
    }.collectFirst { case Some(mhz) => mhz }
  }

  def estimate(log: String): Option[Double] =
    """(?:Total path delay|Timing estimate): [\d.]+ ns \(([\d.]+) MHz\)""".r.findFirstMatchIn(
      log
    ).map(_.group(1).toDouble)
}
