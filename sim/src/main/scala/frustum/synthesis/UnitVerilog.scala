package frustum.synthesis

import frustum.files.OutputFile
import spinal.core._
import java.nio.file.Path

/** Verilog of a unit alone, the same for the same unit. */
object UnitVerilog {

  /** Writes `<name>.v` with the unit as the module of that name; gives the unit. */
  def write[C <: Component](folder: Path, name: String)(unit: => C): C = {
    OutputFile.folder(folder)
    SpinalConfig(
      targetDirectory = folder.toString,
      netlistFileName = s"$name.v",
      defaultConfigForClockDomains = ClockDomainConfig(resetKind = SYNC),
      headerWithDate = false,
      headerWithRepoHash = false,
      inlineRom = true,
      removePruned = true,
      verbose = false
    ).generateVerilog { val c = unit; c.setDefinitionName(name); c }.toplevel
  }
}
