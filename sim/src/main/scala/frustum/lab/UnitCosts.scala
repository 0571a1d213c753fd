package frustum.lab

import frustum.OutputFile
import frustum.boards.flow.{Ice40Flow, Ice40Tools, Yosys}
import spinal.core._
import java.nio.file.{Files, Path}
import java.security.MessageDigest

/** Cells of the iCE40 that yosys makes of one unit. A logic cell holds a LUT and a flip-flop; how many share one is the
  * placer's business, so both are told.
  */
final case class UnitCost(luts: Int, flipFlops: Int, multipliers: Int, blockRams: Int)

/** Synthesis of units alone, kept in `.cache/chart` by a digest of their Verilog.
  *
  * @param say told before each synthesis
  */
final class UnitCosts(say: String => Unit) {
  private lazy val tools = Ice40Tools.find(say)
  private val cache      = Path.of(".cache", "chart")

  def apply(name: String)(unit: => Component): UnitCost = {
    val work = Files.createDirectories(cache.resolve("work"))
    SpinalConfig(
      targetDirectory = work.toString,
      netlistFileName = "unit.v",
      defaultConfigForClockDomains = ClockDomainConfig(resetKind = SYNC),
      headerWithDate = false,
      headerWithRepoHash = false,
      inlineRom = true,
      removePruned = true,
      verbose = false
    ).generateVerilog { val c = unit; c.setDefinitionName("unit"); c }
    val verilog = Files.readAllBytes(work.resolve("unit.v"))
    val digest  = MessageDigest.getInstance("SHA-256").digest(verilog).take(12).map("%02x".format(_)).mkString
    val kept    = cache.resolve(s"$digest.json")
    if (!Files.exists(kept)) {
      say(s"synthesising $name")
      Yosys.synthesise(tools.yosys, work, "unit", s"${Ice40Flow.Synthesis} -top unit")
      val cells =
        ujson.read(Files.readString(work.resolve("unit.netlist.json")))("modules")("unit")("cells").obj.values
          .map(_("type").str).groupBy(identity).view.mapValues(_.size).toMap
      def count(of: String => Boolean) = cells.collect { case (kind, n) if of(kind) => n }.sum
      OutputFile.writeText(
        kept,
        ujson.write(ujson.Obj(
          "unit"        -> name,
          "luts"        -> count(_ == "SB_LUT4"),
          "flipFlops"   -> count(_.startsWith("SB_DFF")),
          "multipliers" -> count(_ == "SB_MAC16"),
          "blockRams"   -> count(_.startsWith("SB_RAM40"))
        ))
      )
    }
    val figures         = ujson.read(Files.readString(kept))
    def of(key: String) = figures(key).num.toInt
    UnitCost(of("luts"), of("flipFlops"), of("multipliers"), of("blockRams"))
  }
}
