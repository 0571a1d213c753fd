package frustum.boards.flow

/** yosys and nextpnr for Artix-7. YoWASP has no nextpnr for it: both are taken from PATH. */
final case class Artix7Tools(yosys: Tool, nextpnr: Tool)

object Artix7Tools {
  private val names = Seq("nextpnr-himbaechel-xilinx", "nextpnr-himbaechel")

  def find(): Artix7Tools = {
    def missing(what: String) = throw MissingTool(
      s"$what is not on PATH: install Debian's yosys, ${names.head} and ${names.head}-chipdb, of Debian 14 or later"
    )
    def newEnough(name: String, oldest: (Int, Int)) = s"$name ${oldest._1}.${oldest._2} or newer"
    val yosys = Tool.native("yosys", "-V", Ice40Tools.OldestYosys)
    val nextpnr = names.flatMap(Tool.native(_, "--version", Nextpnr.Oldest)).headOption
    Artix7Tools(
      yosys.getOrElse(missing(newEnough("yosys", Ice40Tools.OldestYosys))),
      nextpnr.getOrElse(missing(newEnough(names.head, Nextpnr.Oldest)))
    )
  }
}
