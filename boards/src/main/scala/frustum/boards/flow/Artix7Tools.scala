package frustum.boards.flow

/** yosys and nextpnr for Artix-7. YoWASP has no nextpnr for it: both come from PATH. */
final case class Artix7Tools(yosys: Tool, nextpnr: Tool)

object Artix7Tools {
  private val names = Seq("nextpnr-himbaechel-xilinx", "nextpnr-himbaechel")

  def find(): Artix7Tools = {
    def missing(what: String) = throw MissingTool(
      s"$what is not on PATH: install Debian's yosys, ${names.head} and ${names.head}-chipdb, of Debian 14 or later"
    )
    val (major, minor) = Ice40Tools.OldestYosys
    Artix7Tools(
      Tool.native("yosys", "-V", (major, minor)).getOrElse(missing(s"yosys $major.$minor or newer")),
      names.flatMap(Tool.native(_, "--version", Nextpnr.Oldest)).headOption.getOrElse(missing(s"${names.head} ${Nextpnr.Oldest._1}.${Nextpnr.Oldest._2} or newer"))
    )
  }
}
