package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path, Paths, StandardCopyOption}
import scala.math.Ordering.Implicits._

/** yosys and nextpnr for Artix-7. YoWASP has no nextpnr for it: it comes from PATH. */
final case class Artix7Tools(yosys: Tool, nextpnr: Tool) {
  def engine: String = s"yosys ${yosys.version}, nextpnr-himbaechel-xilinx ${nextpnr.version}"
}

object Artix7Tools {
  private val Names = Seq("nextpnr-himbaechel-xilinx", "nextpnr-himbaechel")

  def find(): Artix7Tools = {
    def version(path: String, flag: String) = Tool.version(Tool.output(Seq(path, flag)))
    def missing(what: String)               = throw MissingTool(
      s"$what is not on PATH: install Debian's yosys, ${Names.head} and ${Names.head}-chipdb, of Debian 13 or later"
    )
    val yosys = Tool.onPath("yosys").flatMap { path =>
      version(path, "-V").filter(_ >= Ice40Tools.OldestYosys).map(v => Tool("yosys", s"${v._1}.${v._2}", Seq(path), Map()))
    }
    val nextpnr = Names.flatMap(Tool.onPath).flatMap { path =>
      version(path, "--version").map(v => Tool("nextpnr-himbaechel", s"${v._1}.${v._2}", Seq(path), Map()))
    }
    Artix7Tools(
      yosys.headOption.getOrElse(missing(s"yosys ${Ice40Tools.OldestYosys._1}.${Ice40Tools.OldestYosys._2} or newer")),
      nextpnr.headOption.getOrElse(missing(Names.head))
    )
  }
}

/** From a top to FASM, the text that Project X-Ray's tools make a bitstream of: elaborate, synthesise, place. */
object Artix7Flow {

  /** Builds in `directory/<name>.build` and leaves `directory/<name>.fasm` of the best seed when the design fits.
    *
    * @param say told of each step as it ends
    */
  def run(top: BoardTop, seeds: Seq[Int], directory: Path, tools: Artix7Tools, say: String => Unit): BitstreamReport = {
    val work = directory.resolve(s"${top.name}.build")
    Files.createDirectories(work)
    work.toFile.listFiles.filter(_.isFile).foreach(_.delete())
    val module = top.writeVerilog(work.toString)
    say(s"elaborated $module into $work/${top.name}.v")
    synthesise(tools.yosys, work, top.name, module)
    say(s"synthesised with yosys ${tools.yosys.version}")
    val pins   = Files.readString(Paths.get(top.constraints))
    val clocks = top.otherClocks.map(c => s"create_clock -period ${1000 / c.mhz} [get_ports ${c.net}]\n").mkString
    Files.writeString(work.resolve(s"${top.name}.xdc"), s"$pins\n$clocks")
    val placements = seeds.zipWithIndex.map { case (seed, i) =>
      val placement = place(tools.nextpnr, work, top, seed)
      say(s"seed $seed (${i + 1} of ${seeds.length}): ${placement.summary}")
      placement
    }
    val report = BitstreamReport(top, tools.engine, placements, Nil)
    if (report.fits)
      Files.copy(
        work.resolve(s"${top.name}.${report.bestSeed}.fasm"),
        directory.resolve(s"${top.name}.fasm"),
        StandardCopyOption.REPLACE_EXISTING
      )
    report
  }

  private def synthesise(tool: Tool, work: Path, name: String, module: String): Unit = {
    val log    = s"$name.yosys.log"
    val script = s"read_verilog $name.v; synth_xilinx -family xc7 -abc9 -top $module -json $name.netlist.json"
    if (tool.run(work, log, Seq("-p", script)) != 0)
      throw FlowFault(s"yosys failed on $name.v: ${Tool.faults(work.resolve(log))} (${work.resolve(log)})")
  }

  private def place(tool: Tool, work: Path, top: BoardTop, seed: Int): Placement = {
    val run = s"${top.name}.$seed"
    val log = work.resolve(s"$run.nextpnr.log")
    val code = tool.run(
      work,
      log.getFileName.toString,
      Seq("--device", top.part.packageName, "--json", s"${top.name}.netlist.json", "-o", s"xdc=${top.name}.xdc") ++
        Seq("-o", s"fasm=$run.fasm", "--report", s"$run.report.json", "--freq", s"${top.targetMHz}", "--seed", s"$seed") ++
        Seq("--timing-allow-fail")
    )
    val (used, available) = Nextpnr.utilisation(Files.readString(log))
    val tooBig            = used.exists { case (kind, n) => n > available(kind) }
    if (code != 0 && !tooBig) throw FlowFault(s"nextpnr failed on ${top.name}: ${Tool.faults(log)} ($log)")
    val clocks =
      if (code != 0) Map.empty[String, (Double, Double)]
      else Nextpnr.clockFigures(ujson.read(Files.readString(work.resolve(s"$run.report.json"))))
    Placement(seed, code == 0, used, available, clocks)
  }
}
