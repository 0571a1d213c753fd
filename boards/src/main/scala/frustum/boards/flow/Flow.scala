package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path, StandardCopyOption}

/** From a top to its board's file: elaborate, synthesise, place with each seed. Each part has a flow of its own. */
abstract class Flow {
  protected def yosys: Tool
  protected def nextpnr: Tool

  /** The programs and their versions. */
  protected def engine: String

  /** Yosys' pass for the part, with its options. */
  protected def synthesis: String

  /** Writes the pins, and a frequency for every clock that nextpnr takes one for, beside the netlist. */
  protected def writeConstraints(work: Path, top: BoardTop): Unit

  /** nextpnr's arguments for the part, its constraints and what it writes as `<run>.*`. */
  protected def placement(top: BoardTop, run: String): Seq[String]

  /** A second timing analysis of a placement, in MHz. */
  protected def secondOpinion(work: Path, top: BoardTop, seed: Int): Option[Double] = None

  /** Makes the file for the board of a placement and returns its path; None for a flow without a file for the board. */
  protected def pack(work: Path, top: BoardTop, seed: Int): Option[Path] = None

  /** Builds in `directory/<name>.build` and leaves the file for the board of the best seed beside it when the design
    * fits.
    *
    * @param say    receives a line when each step ends
    * @param placer of nextpnr
    */
  final def run(
      top: BoardTop,
      seeds: Seq[Int],
      directory: Path,
      say: String => Unit,
      placer: String
  ): BitstreamReport = {
    val work = directory.resolve(s"${top.name}.build")
    Files.createDirectories(work)
    work.toFile.listFiles.filter(_.isFile).foreach(_.delete())
    val module = top.writeVerilog(work.toString)
    say(s"elaborated $module into $work/${top.name}.v")
    Yosys.synthesise(yosys, work, top.name, s"$synthesis -top $module")
    say(s"synthesised with yosys ${yosys.version}")
    writeConstraints(work, top)
    val results = seeds.zipWithIndex.map { case (seed, i) =>
      val placed = Nextpnr.place(nextpnr, work, top, seed, placer, placement(top, s"${top.name}.$seed"))
      val second = if (placed.fits) secondOpinion(work, top, seed) else None
      val told = placed.summary +: second.map(mhz => f"icetime $mhz%.2f MHz").toSeq
      say(s"seed $seed (${i + 1} of ${seeds.length}): ${told.mkString(", ")}")
      (placed, second)
    }
    val report = BitstreamReport(top, s"$engine, placer $placer", results.map(_._1), results.flatMap(_._2))
    if (report.fits)
      for (file <- pack(work, top, report.bestSeed)) {
        val ending = file.getFileName.toString.split('.').last
        Files.move(file, directory.resolve(s"${top.name}.$ending"), StandardCopyOption.REPLACE_EXISTING)
      }
    report
  }
}
