package frustum.synthesis

import frustum.boards.flow.{FlowFault, Ice40Flow, Ice40Tools, Nextpnr, Tool, Yosys}
import frustum.files.{Digest, OutputFile}
import spinal.core._
import java.nio.file.{Files, Path}

/** Cells of the iCE40 that yosys makes of one unit. A logic cell holds a LUT and a flip-flop; how many share one is the
  * placer's business, so both are told.
  *
  * @param clockMHz of the unit alone on the UP5K, the slowest of [[UnitCosts.Seeds]] placements; None where it was not
  *   placed or does not fit
  */
final case class UnitCost(
    luts: Int,
    flipFlops: Int,
    multipliers: Int,
    blockRams: Int,
    clockMHz: Option[Double] = None
) {
  def cells: Double = (luts + flipFlops).toDouble

  /** By their names in reports. */
  def figures: Seq[(String, Option[Double])] = UnitCost.names.zip(
    Seq(luts, flipFlops, multipliers, blockRams).map(n => Some(n.toDouble)) :+ clockMHz
  )
}
object UnitCost {
  val names: Seq[String] = Seq("luts", "flipFlops", "multipliers", "blockRams", "clockMHz")
}

/** Synthesis, place and route of units alone, kept in `.cache/chart` by a digest of their Verilog and of
  * yosys' pass.
  *
  * @param say told before each run
  */
final class UnitCosts(say: String => Unit) {
  private lazy val tools = Ice40Tools.find(say)
  private val cache = Path.of(".cache", "chart")
  private val work = cache.resolve("work")

  /** What synthesis makes of it. */
  def apply(name: String)(unit: => Component): UnitCost = {
    val figures = kept("unit")(unit) {
      say(s"synthesising $name")
      val cells = synthesised("unit")
      def count(of: String => Boolean) = cells.collect { case (kind, n) if of(kind) => n }.sum
      ujson.Obj(
        "unit" -> name,
        "luts" -> count(_ == "SB_LUT4"),
        "flipFlops" -> count(_.startsWith("SB_DFF")),
        "multipliers" -> count(_ == "SB_MAC16"),
        "blockRams" -> count(_.startsWith("SB_RAM40"))
      )
    }
    def of(key: String) = figures(key).num.toInt
    UnitCost(of("luts"), of("flipFlops"), of("multipliers"), of("blockRams"))
  }

  /** The same with the clock that it reaches between registers. */
  def timed(name: String)(unit: => Component): UnitCost = {
    val figures = kept("timed")(new RegisteredUnit(unit)) {
      synthesised("timed")
      val clocks = (1 to UnitCosts.Seeds).map { seed =>
        say(s"placing $name, seed $seed")
        place(seed)
      }
      ujson.Obj(
        "unit" -> name,
        "clockMHz" -> clocks.flatten.minOption.fold[ujson.Value](ujson.Null)(ujson.Num(_))
      )
    }
    apply(name)(unit).copy(clockMHz = figures("clockMHz").numOpt)
  }

  /** MHz, or None where the unit does not fit. */
  private def place(seed: Int): Option[Double] = {
    val log = "timed.nextpnr.log"
    val code = tools.nextpnr.run(
      work,
      log,
      Seq("--placer", Nextpnr.Heap, "--up5k", "--package", "sg48", "--json", "timed.netlist.json") ++
        Seq("--report", "timed.report.json", "--freq", "100", "--seed", s"$seed") ++
        Seq("--timing-allow-fail", "--pcf-allow-unconstrained")
    )
    if (code == 0)
      Nextpnr.clockFigures(
        ujson.read(Files.readString(work.resolve("timed.report.json")))
      ).values.map(_._1).minOption
    else if (Nextpnr.tooBig(Files.readString(work.resolve(log)))) None
    else throw FlowFault(s"nextpnr failed: ${Tool.faults(work.resolve(log))} (${work.resolve(log)})")
  }

  /** Cells by their kind. */
  private def synthesised(top: String): Map[String, Int] = {
    Yosys.synthesise(tools.yosys, work, top, s"${Ice40Flow.Synthesis} -top $top")
    ujson.read(Files.readString(work.resolve(s"$top.netlist.json")))("modules")(top)("cells").obj.values
      .map(_("type").str).groupBy(identity).view.mapValues(_.size).toMap
  }

  private def kept(top: String)(unit: => Component)(measure: => ujson.Obj): ujson.Value = {
    UnitVerilog.write(work, top)(unit)
    val verilog = Files.readAllBytes(work.resolve(s"$top.v"))
    val file = cache.resolve(s"${Digest(verilog, Ice40Flow.Synthesis.getBytes)}.json")
    if (!Files.exists(file)) OutputFile.writeText(file, ujson.write(measure))
    ujson.read(Files.readString(file))
  }
}

object UnitCosts {
  val Seeds = 3
}
