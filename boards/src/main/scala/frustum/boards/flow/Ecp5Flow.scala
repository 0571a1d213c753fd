package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path}

/** Speed and size of a design on Lattice's ECP5: no pins, so no file for a board.
  *
  * @param yosys   native or YoWASP's
  * @param nextpnr the same
  */
final class Ecp5Flow(protected val yosys: Tool, protected val nextpnr: Tool) extends Flow {
  protected def engine: String = s"yosys ${yosys.version}, nextpnr-ecp5 ${nextpnr.version}"
  protected def synthesis: String = "synth_ecp5 -abc9 -no-rw-check"

  protected def writeConstraints(work: Path, top: BoardTop): Unit =
    Files.writeString(
      work.resolve(s"${top.name}.lpf"),
      top.clocks.map(c => s"FREQUENCY PORT \"${c.net}\" ${c.mhz} MHZ;\n").mkString
    )

  protected def placement(top: BoardTop, run: String): Seq[String] =
    Seq(
      "--85k",
      "--speed",
      "6",
      "--package",
      top.part.packageName,
      "--lpf",
      s"${top.name}.lpf",
      "--lpf-allow-unconstrained"
    )
}

object Ecp5Flow {

  /** @param say receives a line about each preparation */
  def find(say: String => Unit): Ecp5Flow = new Ecp5Flow(
    Tool.native("yosys", "-V", Ice40Tools.OldestYosys).getOrElse(Yowasp.tool("yosys", "-V", say)),
    Tool.native("nextpnr-ecp5", "--version", Nextpnr.Oldest)
      .getOrElse(Yowasp.tool("nextpnr-ecp5", "--version", say, Yowasp.Ecp5))
  )
}
