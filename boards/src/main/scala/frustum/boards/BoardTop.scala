package frustum.boards

import frustum.device.Tech
import spinal.core._

/** A clock of a top: `net` is its name in the netlist, `mhz` what it has to reach. */
final case class BoardClock(net: String, mhz: BigDecimal, source: String)

/** A design for a board: what to elaborate, for which part, with which pins and clocks.
  *
  * @param constraints pin file, relative to the root of the project
  * @param core        the clock the figures are quoted for
  * @param otherClocks every other clock of the design: a clock that the flow does not find here is an error
  */
final case class BoardTop(
    name: String,
    part: Part,
    constraints: String,
    core: BoardClock,
    otherClocks: Seq[BoardClock],
    component: Tech => Component
) {
  def targetMHz: BigDecimal = core.mhz
  def clocks: Seq[BoardClock] = core +: otherClocks

  /** Verilog in one file `<name>.v`, memory contents inline, so that a tool needs this file only. */
  def spinalConfig(directory: String): SpinalConfig = SpinalConfig(
    targetDirectory = directory,
    netlistFileName = s"$name.v",
    defaultClockDomainFrequency = FixedFrequency(core.mhz.toDouble MHz),
    headerWithDate = false,
    inlineRom = true,
    removePruned = true,
    verbose = false
  )

  /** Elaborates into `<directory>/<name>.v`; gives the name of the Verilog module. */
  def writeVerilog(directory: String): String =
    spinalConfig(directory).generateVerilog(component(part.tech)).toplevel.definitionName

  /** The same design on an ECP5, for its figures: no pins, and the core's clock comes in at `clk`. */
  def onEcp5: BoardTop = copy(
    name = s"$name-ecp5",
    part = Part.Ecp5U85,
    constraints = "",
    core = BoardClock("clk", core.mhz, "a pin"),
    otherClocks = otherClocks.filter(_.net != "clk")
  )
}
