package frustum.boards.flow

import java.nio.file.{Files, Path}

/** Synthesis: `<name>.v` to `<name>.netlist.json`, in one directory. */
object Yosys {

  /** @param synthesis the part's pass with its options, the top module among them */
  def synthesise(tool: Tool, directory: Path, name: String, synthesis: String): Unit = {
    val log = s"$name.yosys.log"
    val script = s"read_verilog $name.v; $synthesis -json $name.netlist.json"
    if (tool.run(directory, log, Seq("-p", script)) != 0) {
      throw FlowFault(s"yosys failed on $name.v: ${Tool.faults(directory.resolve(log))} (${directory.resolve(log)})")
    }
    val dead = deadMultipliers(ujson.read(Files.readString(directory.resolve(s"$name.netlist.json"))))
    if (dead.nonEmpty) throw FlowFault(s"after synthesis these SB_MAC16 have no clock: ${dead.mkString(", ")}")
  }

  /** Multipliers that lost their clock: CLK absent or constant, or CE tied to 0. Placed and routed they would keep
    * their value of power up, and no tool reports it.
    */
  def deadMultipliers(netlist: ujson.Value): Seq[String] =
    for {
      (_, module) <- netlist("modules").obj.toSeq
      (name, cell) <- module.obj.get("cells").map(_.obj.toSeq).getOrElse(Seq())
      if cell("type").str == "SB_MAC16"
      pins = cell("connections").obj
      clocked = pins.get("CLK").exists(_.arr.exists(_.numOpt.isDefined))
      enabled = !pins.get("CE").exists(_.arr.exists(_.strOpt.contains("0")))
      if !clocked || !enabled
    } yield name
}
