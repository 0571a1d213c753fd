package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path, Paths}

/** The flow for the iCE40UP5K, to a bitstream. */
final class Ice40Flow(tools: Ice40Tools) extends Flow {
  protected def yosys: Tool = tools.yosys
  protected def nextpnr: Tool = tools.nextpnr
  protected def engine: String = s"yosys ${yosys.version}, nextpnr-ice40 ${nextpnr.version}"

  protected def synthesis: String = Ice40Flow.Synthesis

  protected def writeConstraints(work: Path, top: BoardTop): Unit = {
    val pins = Files.readString(Paths.get(top.constraints))
    val clocks = top.clocks.map(c => s"set_frequency ${c.net} ${c.mhz} # ${c.source}\n").mkString
    Files.writeString(work.resolve(s"${top.name}.pcf"), s"$pins\n$clocks")
  }

  protected def placement(top: BoardTop, run: String): Seq[String] =
    Seq("--up5k", "--package", top.part.packageName, "--pcf", s"${top.name}.pcf", "--asc", s"$run.asc")

  override protected def secondOpinion(work: Path, top: BoardTop, seed: Int): Option[Double] =
    Icetime.analyse(tools.icetime, work, top, seed)

  override protected def pack(work: Path, top: BoardTop, seed: Int): Option[Path] = {
    val (name, log) = (top.name, s"${top.name}.icepack.log")
    if (tools.icepack.run(work, log, Seq(s"$name.$seed.asc", s"$name.bin")) != 0)
      throw FlowFault(s"icepack failed: ${Tool.faults(work.resolve(log))}")
    Some(work.resolve(s"$name.bin"))
  }
}

object Ice40Flow {

  /** `-no-rw-check`: the library states don't-care where a memory is read and written at one address. No `-dsp`:
    * multipliers are instantiated, and that pass disconnects their clocks. The mapping assumes 1.2 ns of wire before
    * each cell instead of 0.25 ns: nearer to the 1.8 ns of nextpnr on the UP5K, so that paths have fewer cells. With
    * 1.7 ns the design has more cells.
    */
  val Synthesis = "scratchpad -set synth_ice40.abc9.W 1200; synth_ice40 -abc9 -no-rw-check"
}
