package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path}
import scala.concurrent.duration._

/** One placement.
  *
  * @param used   cells of each kind, by nextpnr's names
  * @param clocks MHz reached, and required, by each clock net; empty when the design did not fit
  */
final case class Placement(
    seed: Int,
    fits: Boolean,
    used: Map[String, Int],
    available: Map[String, Int],
    clocks: Map[String, (Double, Double)]
) {
  def summary: String =
    if (!fits) {
      val over =
        used.toSeq.sorted.collect { case (kind, n) if n > available(kind) => s"$n of ${available(kind)} $kind" }
      if (over.isEmpty) "does not fit" else s"does not fit: ${over.mkString(", ")}"
    } else clocks.toSeq.sorted.map { case (net, (got, need)) => f"$net $got%.2f MHz (needs $need%.2f)" }.mkString(", ")
}

/** Place and route: `<name>.netlist.json` to the part's own file. */
object Nextpnr {

  /** Below this the placer that the flow uses does not support the iCE40; Debian 12 has 0.4, Debian 13 has 0.7. */
  val Oldest = (0, 11)

  /** Its placers. `Static` packs designs with much block RAM far better, see docs/flashing.md, but there are designs,
    * small ones among them, with which it does not terminate. `Heap` is nextpnr's own choice.
    */
  val Static = "static"
  val Heap = "heap"
  val Placers = Seq(Static, Heap)

  /** The time after which a placement is stopped. */
  private val Patience = 30.minutes

  /** @param placer one of [[Placers]]
    * @param part   arguments for the device, its constraints and the files to write
    */
  def place(tool: Tool, directory: Path, top: BoardTop, seed: Int, placer: String, part: Seq[String]): Placement = {
    val run = s"${top.name}.$seed"
    val report = directory.resolve(s"$run.report.json")
    Files.deleteIfExists(report)
    val code = tool.runWithin(Patience)(
      directory,
      s"$run.nextpnr.log",
      part ++ Seq("--placer", placer, "--json", s"${top.name}.netlist.json", "--report", s"$run.report.json") ++
        Seq("--freq", s"${top.targetMHz}", "--seed", s"$seed", "--timing-allow-fail")
    ).getOrElse(throw FlowFault(
      s"nextpnr with --placer $placer has not placed ${top.name} within $Patience; use --placer " +
        Placers.filterNot(_ == placer).mkString(" or ")
    ))
    val log = directory.resolve(s"$run.nextpnr.log")
    val said = Files.readString(log)
    val (used, available) = utilisation(said)
    if (code != 0 && !tooBig(said))
      throw FlowFault(s"nextpnr failed on ${top.name}: ${Tool.faults(log)} ($log)")
    val clocks =
      if (code == 0) clockFigures(ujson.read(Files.readString(report))) else Map.empty[String, (Double, Double)]
    Placement(seed, code == 0, used, available, clocks)
  }

  /** Whether a log says that the design does not fit. */
  def tooBig(log: String): Boolean = {
    val (used, available) = utilisation(log)
    used.exists { case (kind, n) => n > available(kind) } || log.contains("no Bels remaining of type") ||
    log.contains("no BELs remaining to implement cell type")
  }

  /** The table "Device utilisation" of nextpnr's log, which is there even when the design does not fit. */
  def utilisation(log: String): (Map[String, Int], Map[String, Int]) = {
    val row = """Info:\s+([A-Z0-9_]+):\s+(\d+)/\s*(\d+)\s+\d+%""".r
    val rows = row.findAllMatchIn(log).toSeq.map(m => (m.group(1), m.group(2).toInt, m.group(3).toInt))
    (rows.map(r => r._1 -> r._2).toMap, rows.map(r => r._1 -> r._3).toMap)
  }

  /** MHz reached and required of every clock of nextpnr's report. */
  def clockFigures(report: ujson.Value): Map[String, (Double, Double)] =
    report("fmax").obj.map { case (net, f) => net -> ((f("achieved").num, f("constraint").num)) }.toMap
}
