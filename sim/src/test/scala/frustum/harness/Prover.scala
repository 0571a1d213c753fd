package frustum.harness

import frustum.boards.flow.{MissingTool, Tool, Yowasp}
import org.scalatest.Assertions
import spinal.core._

import java.nio.file.{Files, Path, Paths}
import scala.jdk.CollectionConverters._

/** Shows by SymbiYosys and z3 that no assertion of a component can fail. A test that needs it is cancelled with a
  * notice where a tool is missing.
  */
object Prover extends Assertions {
  private val folder = Paths.get("simWorkspace", "formal")

  /** SymbiYosys from PATH, or the one beside Yosys from PyPI, which is told where its own parts are. */
  private lazy val sby: Either[String, Tool] = {
    def native = Tool.onPath("sby").headOption.map(path => Tool("sby", "", Seq(path), Map()))
    def python = {
      def own(name: String) = Yowasp.tool(name, "", _ => ())
      Yowasp.tool("yosys", "--version", _ => ()) // its first call compiles it, which may take longer than a proof may
      val tool = own("sby")
      val parts = Map("YOSYS" -> "yosys", "SMTBMC" -> "yosys-smtbmc", "WITNESS" -> "yosys-witness")
      tool.copy(environment = tool.environment ++ parts.map { case (key, name) =>
        key -> own(name).command.head
      })
    }
    if (Tool.onPath("z3").isEmpty) Left("z3 is not here: install the package of that name")
    else
      try Right(native.getOrElse(python))
      catch { case missing: MissingTool => Left(missing.message) }
  }

  /** By induction: from any state that keeps the assertions for `depth` clocks follows one that keeps them, and so do
    * the first `depth` clocks after reset.
    */
  def prove(name: String, depth: Int)(top: => Component): Unit = {
    val tool = sby.fold(notice => cancel(s"nothing is proved: $notice"), identity)
    val at = Files.createDirectories(folder.resolve(name)).toAbsolutePath
    val report = SpinalConfig(
      targetDirectory = at.toString,
      defaultConfigForClockDomains = ClockDomainConfig(resetKind = SYNC)
    ).includeFormal.generateSystemVerilog(top)
    val file = s"${report.toplevelName}.sv"
    val tables = at.toFile.list.filter(name => name.startsWith(file) && name.endsWith(".bin"))
    Files.writeString(
      at.resolve("task.sby"),
      s"""[options]
         |mode prove
         |depth $depth
         |timeout 120
         |[engines]
         |smtbmc --unroll z3
         |[script]
         |read -formal $file
         |prep -top ${report.toplevelName}
         |[files]
         |${(file +: tables).map(name => s"$at/$name").mkString("\n")}
         |""".stripMargin
    )
    val code = tool.run(at, "sby.log", Seq("-f", "task.sby"))
    if (code != 0)
      fail(s"$name: ${faults(at.resolve("sby.log"), at.resolve(file))} (all of it in $at/sby.log)")
  }

  /** The assertions that fail, with their places in the sources; otherwise what SymbiYosys says at its end. */
  private def faults(log: Path, source: Path): String = {
    val lines = Files.readAllLines(log).asScala.toSeq
    val code = Files.readAllLines(source).asScala
    val failed = lines.filter(l => l.contains("ssert failed in")).flatMap { l =>
      """\.sv:(\d+)\.""".r.findFirstMatchIn(l).map { m =>
        val way = if (l.contains("induction")) "no induction" else "fails"
        s"$way: ${code(m.group(1).toInt - 1).trim}"
      }
    }
    if (failed.nonEmpty) failed.distinct.mkString("; ") else lines.takeRight(1).mkString
  }
}
