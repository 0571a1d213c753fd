package frustum.command.bitstream

import frustum.boards.{BoardTop, Part}
import frustum.boards.flow.{Artix7Flow, Artix7Tools, BitstreamReport, Ecp5Flow, Ice40Flow, Ice40Tools, MissingTool}
import frustum.BuildInfo
import frustum.command.common.{CommandLine, TopArguments}
import frustum.contract.InputError
import frustum.files.OutputFile
import java.nio.file.{Files, Path, Paths}

/** `bitstream TOP`: synthesis, place and route; writes `out/bitstream/TOP.bin` (Arty: `TOP.fasm`) and the figures to
  * `TOP.json` there. With `--ecp5` the figures on another maker's part, `TOP-ecp5.json`.
  */
object BitstreamCommand extends CommandLine {
  val name = "bitstream"
  val summary =
    "builds a board's top; writes out/bitstream/TOP.bin (Arty: .fasm) and the figures to out/bitstream/TOP.json"

  private val parser = TopArguments.parser(name, summary, seeds = true)

  def run(args: Seq[String]): Int =
    TopArguments.parse(parser, args).fold(0) { arguments =>
      val top = if (arguments.ecp5) arguments.find.onEcp5 else arguments.find
      val directory = Paths.get("out", "bitstream")
      val files = Seq("json", "bin", "fasm").map(kind => directory.resolve(s"${top.name}.$kind"))
      OutputFile.check(files: _*)
      // What an earlier run left would pass for this run's if this one failed.
      files.foreach(Files.deleteIfExists(_))
      val report = build(top, arguments.seeds, arguments.placer, directory)
      val file = directory.resolve(s"${top.name}.json")
      OutputFile.writeText(file, ujson.write(report.json(BuildInfo.version), indent = 2) + "\n")
      println(s"wrote $file")
      verdict(report)
    }

  private def build(top: BoardTop, seeds: Int, placer: String, directory: Path): BitstreamReport = {
    def say(line: String): Unit = println(s"$name ${top.name}: $line")
    try {
      println(
        s"$name ${top.name}: target ${top.targetMHz} MHz (${top.core.source}), seeds ${(1 to seeds).mkString(", ")}"
      )
      val flow = top.part match {
        case Part.Ice40Up5k => new Ice40Flow(Ice40Tools.find(say))
        case _: Part.Artix7 => new Artix7Flow(Artix7Tools.find())
        case Part.Ecp5U85   => Ecp5Flow.find(say)
      }
      val report = flow.run(top, 1 to seeds, directory, say, placer)
      if (report.fits && top.part == Part.Ice40Up5k && report.icetimeMHz.isEmpty)
        say(
          "no icetime here, so no icetimeMHz in the report; it is in Debian's fpga-icestorm and fpga-icestorm-chipdb"
        )
      report
    } catch { case MissingTool(message) => throw InputError(message) }
  }

  private def verdict(report: BitstreamReport): Int = {
    val top = report.top
    if (!report.fits) Console.err.println(
      s"error: ${top.name} does not fit the ${top.part.name}; see out/bitstream/${top.name}.json"
    )
    else if (!report.meetsTarget) {
      val slow = report.shortfalls ++ report.icetimeMHz.filter(_ < top.targetMHz.toDouble).map(mhz =>
        s"icetime $mhz MHz"
      )
      Console.err.println(
        s"error: ${top.name} misses its target of ${top.targetMHz} MHz: ${slow.mkString("; ")}"
      )
    } else println(
      f"${top.name}: fits, ${report.coreMHz.min}%.2f MHz at the least of ${report.placements.length} seeds"
    )
    if (report.meetsTarget) 0 else 1
  }
}
