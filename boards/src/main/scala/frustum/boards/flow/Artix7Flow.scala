package frustum.boards.flow

import frustum.boards.BoardTop
import java.nio.file.{Files, Path, Paths}

/** The flow for Artix-7, to FASM, the text that Project X-Ray's tools make a bitstream of. */
final class Artix7Flow(tools: Artix7Tools) extends Flow {
  protected def yosys: Tool = tools.yosys
  protected def nextpnr: Tool = tools.nextpnr
  protected def engine: String = s"yosys ${yosys.version}, nextpnr-himbaechel-xilinx ${nextpnr.version}"
  protected def synthesis: String = "synth_xilinx -family xc7 -abc9"

  /** nextpnr takes a frequency for pads alone; the core's is that of `--freq`. */
  protected def writeConstraints(work: Path, top: BoardTop): Unit = {
    val pins = Files.readString(Paths.get(top.constraints))
    val clocks =
      top.otherClocks.map(c => s"create_clock -period ${1000 / c.mhz} [get_ports ${c.net}]\n").mkString
    Files.writeString(work.resolve(s"${top.name}.xdc"), s"$pins\n$clocks")
  }

  protected def placement(top: BoardTop, run: String): Seq[String] =
    Seq("--device", top.part.packageName, "-o", s"xdc=${top.name}.xdc", "-o", s"fasm=$run.fasm")

  override protected def pack(work: Path, top: BoardTop, seed: Int): Option[Path] =
    Some(work.resolve(s"${top.name}.$seed.fasm"))
}
