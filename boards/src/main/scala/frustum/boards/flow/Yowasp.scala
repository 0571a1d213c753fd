package frustum.boards.flow

import java.nio.file.{Files, Path, Paths}

/** Yosys, nextpnr and icepack compiled to WebAssembly, from PyPI, at the versions of lists in `project`.
  * They live in a virtual environment under `.cache/yowasp`, made when they are first needed.
  */
object Yowasp {

  /** What `project/yowasp.txt` lists: yosys, nextpnr-ice40, icepack. */
  val Ice40 = "yowasp.txt"

  /** What `project/yowasp-ecp5.txt` lists: nextpnr-ecp5, about 170 MB. */
  val Ecp5 = "yowasp-ecp5.txt"

  private val home = Paths.get(".cache", "yowasp").toAbsolutePath
  private val compiled = Map("YOWASP_CACHE_DIR" -> home.resolve("compiled").toString)

  /** The tool `yowasp-<name>`.
    *
    * @param versionFlag prints its version; empty when there is no such flag
    * @param list        names the tool's package, in addition to those of [[Ice40]]
    */
  def tool(name: String, versionFlag: String, say: String => Unit, list: String = Ice40): Tool = {
    install(Ice40, say)
    if (list != Ice40) install(list, say)
    val command = Seq(home.resolve("bin").resolve(s"yowasp-$name").toString)
    val version = if (versionFlag.isEmpty) None else Tool.version(Tool.output(command :+ versionFlag, compiled))
    Tool(name, version.map(v => s"${v._1}.${v._2}").getOrElse(""), command, compiled)
  }

  /** Installs what a list names unless exactly that is there. The first list creates the environment again, without the
    * packages of others.
    */
  private def install(list: String, say: String => Unit): Unit = {
    val requirements = Paths.get("project", list)
    val stamp = home.resolve(s"installed-$list")
    val wanted = Files.readString(requirements)
    if (!Files.exists(stamp) || Files.readString(stamp) != wanted) {
      val packages = wanted.linesIterator.filterNot(_.startsWith("#")).map(_.takeWhile(_ != '=')).mkString(", ")
      say(s"installing $packages from PyPI into .cache/yowasp (once, about a minute)")
      Files.createDirectories(home)
      if (list == Ice40)
        step(
          "venv.log",
          packages,
          "install the package python3-venv",
          Seq("python3", "-m", "venv", "--clear", s"$home")
        )
      step(
        "pip.log",
        packages,
        "check the network, or put yosys >= 0.40, icepack and nextpnr >= 0.11 for the part on PATH",
        Seq(s"$home/bin/python", "-m", "pip", "install", "--quiet", "-r", requirements.toAbsolutePath.toString)
      )
      Files.writeString(stamp, wanted)
    }
  }

  private def step(log: String, packages: String, remedy: String, command: Seq[String]): Unit = {
    val directory: Path = Files.createDirectories(home.resolveSibling("log"))
    val done =
      try Tool(command.head, "", command, Map()).run(directory, log, Seq()) == 0
      catch { case _: java.io.IOException => false }
    if (!done) throw MissingTool(s"cannot install $packages (.cache/log/$log): $remedy")
  }
}
