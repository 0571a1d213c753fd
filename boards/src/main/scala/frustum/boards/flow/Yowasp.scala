package frustum.boards.flow

import java.nio.file.{Files, Path, Paths}

/** Yosys, nextpnr and icepack compiled to WebAssembly, from PyPI, at the versions of `project/yowasp.txt`.
  * They live in a virtual environment under `.cache/yowasp`, made when they are first needed.
  */
object Yowasp {
  private val requirements = Paths.get("project", "yowasp.txt")
  private val home         = Paths.get(".cache", "yowasp").toAbsolutePath
  private val compiled     = Map("YOWASP_CACHE_DIR" -> home.resolve("compiled").toString)

  /** The tool `yowasp-<name>`; `versionFlag` makes it tell its version, empty when it has no such flag. */
  def tool(name: String, versionFlag: String, say: String => Unit): Tool = {
    install(say)
    val command = Seq(home.resolve("bin").resolve(s"yowasp-$name").toString)
    val version = if (versionFlag.isEmpty) None else Tool.version(Tool.output(command :+ versionFlag, compiled))
    Tool(name, version.map(v => s"${v._1}.${v._2}").getOrElse(""), command, compiled)
  }

  /** Makes the environment unless it holds exactly the wanted versions. */
  private def install(say: String => Unit): Unit = {
    val stamp  = home.resolve("installed.txt")
    val wanted = Files.readString(requirements)
    if (!Files.exists(stamp) || Files.readString(stamp) != wanted) {
      say("installing yosys and nextpnr-ice40 from PyPI into .cache/yowasp (once, about a minute)")
      Files.createDirectories(home)
      step("venv.log", "install the package python3-venv", Seq("python3", "-m", "venv", "--clear", s"$home"))
      step(
        "pip.log",
        "check the network, or put yosys >= 0.40, nextpnr-ice40 >= 0.7 and icepack on PATH",
        Seq(s"$home/bin/python", "-m", "pip", "install", "--quiet", "-r", requirements.toAbsolutePath.toString)
      )
      Files.writeString(stamp, wanted)
    }
  }

  private def step(log: String, remedy: String, command: Seq[String]): Unit = {
    val directory: Path = Files.createDirectories(home.resolveSibling("log"))
    val done =
      try Tool(command.head, "", command, Map()).run(directory, log, Seq()) == 0
      catch { case _: java.io.IOException => false }
    if (!done) throw MissingTool(s"cannot install yosys and nextpnr-ice40 (.cache/log/$log): $remedy")
  }
}
