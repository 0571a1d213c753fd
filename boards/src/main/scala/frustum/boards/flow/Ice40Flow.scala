package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path}

/** From a top to a bitstream: elaborate, synthesise, place with each seed, analyse timing, pack. */
object Ice40Flow {

  /** Builds in `directory/<name>.build` and leaves `directory/<name>.bin` of the best seed when the design fits.
    *
    * @param say told of each step as it ends
    */
  def run(top: BoardTop, seeds: Seq[Int], directory: Path, tools: Ice40Tools, say: String => Unit): BitstreamReport = {
    val work = directory.resolve(s"${top.name}.build")
    Files.createDirectories(work)
    work.toFile.listFiles.filter(_.isFile).foreach(_.delete())
    val module = top.writeVerilog(work.toString)
    say(s"elaborated $module into $work/${top.name}.v")
    Yosys.synthesise(tools.yosys, work, top.name, module)
    say(s"synthesised with yosys ${tools.yosys.version}")
    Nextpnr.writeConstraints(work, top)
    val results = seeds.zipWithIndex.map { case (seed, i) =>
      val placement = Nextpnr.place(tools.nextpnr, work, top, seed)
      val icetime   = if (placement.fits) Icetime.analyse(tools.icetime, work, top, seed) else None
      say(s"seed $seed (${i + 1} of ${seeds.length}): " + summary(placement, icetime))
      (placement, icetime)
    }
    val report = BitstreamReport(top, tools.engine, results.map(_._1), results.flatMap(_._2))
    if (report.fits) pack(tools.icepack, work, top.name, report.bestSeed, directory)
    report
  }

  private def summary(placement: Placement, icetime: Option[Double]): String =
    (placement.summary +: icetime.map(mhz => f"icetime $mhz%.2f MHz").toSeq).mkString(", ")

  private def pack(icepack: Tool, work: Path, name: String, seed: Int, directory: Path): Unit = {
    if (icepack.run(work, s"$name.icepack.log", Seq(s"$name.$seed.asc", s"$name.bin")) != 0)
      throw FlowFault(s"icepack failed: ${Tool.faults(work.resolve(s"$name.icepack.log"))}")
    Files.move(work.resolve(s"$name.bin"), directory.resolve(s"$name.bin"), java.nio.file.StandardCopyOption.REPLACE_EXISTING)
  }
}
