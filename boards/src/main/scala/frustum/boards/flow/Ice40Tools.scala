package frustum.boards.flow

/** The programs that make an iCE40 bitstream: native ones from PATH where they are new enough, else YoWASP's from PyPI.
  */
final case class Ice40Tools(yosys: Tool, nextpnr: Tool, icepack: Tool, icetime: Seq[Tool])

object Ice40Tools {

  /** Below this yosys lacks options the flow relies on; Debian 12 has 0.23. */
  val OldestYosys = (0, 40)

  /** @param say receives a line about each preparation */
  def find(say: String => Unit): Ice40Tools = {
    val yosys = Tool.native("yosys", "-V", OldestYosys)
    val nextpnr = Tool.native("nextpnr-ice40", "--version", Nextpnr.Oldest)
    val icepack = Tool.onPath("icepack").headOption.map(path => Tool("icepack", "", Seq(path), Map()))
    Ice40Tools(
      yosys.getOrElse(Yowasp.tool("yosys", "-V", say)),
      nextpnr.getOrElse(Yowasp.tool("nextpnr-ice40", "--version", say)),
      icepack.getOrElse(Yowasp.tool("icepack", "", say)),
      Tool.onPath("icetime").map(path => Tool("icetime", "", Seq(path), Map()))
    )
  }
}
