package frustum.boards.flow

import java.nio.file.{Files, Path}

/** Synthesis for the iCE40: `<name>.v` to `<name>.netlist.json`, in one directory. */
object Yosys {

  /** `-no-rw-check`: the library states don't-care where a memory is read and written at one address.
    * No `-dsp`: multipliers are instantiated, and that pass disconnects their clocks.
    */
  def script(name: String, module: String): String =
    s"read_verilog $name.v; synth_ice40 -abc9 -no-rw-check -top $module -json $name.netlist.json"

  def synthesise(tool: Tool, directory: Path, name: String, module: String): Unit = {
    val log = s"$name.yosys.log"
    if (tool.run(directory, log, Seq("-p", script(name, module))) != 0) {
      throw FlowFault(s"yosys failed on $name.v: ${Tool.faults(directory.resolve(log))} (${directory.resolve(log)})")
    }
    val dead = deadMultipliers(ujson.read(Files.readString(directory.resolve(s"$name.netlist.json"))))
    if (dead.nonEmpty) throw FlowFault(s"after synthesis these SB_MAC16 have no clock: ${dead.mkString(", ")}")
  }

  /** Multipliers that lost their clock: CLK absent or constant, or CE tied to 0. Placed and routed they would keep
    * what they held at power up, and no tool says a word.
    */
  def deadMultipliers(netlist: ujson.Value): Seq[String] =
    for {
      (_, module)  <- netlist("modules").obj.toSeq
      (name, cell) <- module.obj.get("cells").map(_.obj.toSeq).getOrElse(Seq())
      if cell("type").str == "SB_MAC16"
      pins = cell("connections").obj
      clocked = pins.get("CLK").exists(_.arr.exists(_.numOpt.isDefined))
      enabled = !pins.get("CE").exists(_.arr.exists(_.strOpt.contains("0")))
      if !clocked || !enabled
    } yield name
}
