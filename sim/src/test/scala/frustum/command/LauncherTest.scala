package frustum.command

import org.scalatest.funsuite.AnyFunSuite
import scala.sys.process._

/** Which command lines ./sbt runs itself, and which it leaves to sbt. */
class LauncherTest extends AnyFunSuite {
  private def taken(words: String*): Boolean =
    Seq("bash", "-c", ". project/command.sh; is_command \"$@\"", "bash").++(words).! == 0

  test("a command line, or a command and its options, is run outside of sbt") {
    for (
      words <-
        Seq(
          Seq("demo"),
          Seq("play pong"),
          Seq("render --scene teapot"),
          Seq("render", "--obj", "a b.obj"),
          Seq("render --bad")
        )
    )
      assert(taken(words: _*), words)
  }

  test("anything else is sbt's") {
    for (
      words <- Seq(
        Seq(),
        Seq("test"),
        Seq("quick"),
        Seq("sim/test"),
        Seq("demo", "test"),
        Seq("clean", "demo"),
        Seq("renderer"),
        Seq("--help")
      )
    )
      assert(!taken(words: _*), words)
  }

  /** Exit code and message of what the launcher does before anything else. */
  private def mistyped(words: String*): (Int, String) = {
    val said = new StringBuilder
    val script = ". project/setup.sh; . project/command.sh; refuse_mistyped \"$@\""
    val code = Seq("bash", "-c", script, "bash").++(words).!(ProcessLogger(_ => (), line => said ++= line))
    (code, said.result())
  }

  test("a mistyped command is refused in one line with the nearest names") {
    for (
      (typed, meant) <- Seq(
        "rendr" -> "render",
        "rednre --scene cube" -> "render",
        "demp" -> "demo",
        "chrt leaps" -> "chart",
        "bitsream" -> "bitstream",
        "stabilty" -> "stability",
        "pang" -> "pong",
        "raport" -> "report"
      )
    ) {
      val (code, said) = mistyped(typed)
      assert(code == 2 && said.startsWith("error: ") && said.contains(s"did you mean $meant"), (typed, said))
    }
    assert(mistyped("rendr", "--scene", "cube")._1 == 2)
  }

  test("sbt's own commands and tasks are left to sbt") {
    val own =
      "about alias boot clean client compile completions console consoleQuick copyResources crossScalaVersions " +
        "dependencyTree doc early eval evicted exit export fgRun full help history init inspect last load new " +
        "onFailure package plugins plz runner print projects project publish publishLocal publishM2 quick quit " +
        "reboot reload rollback run runMain scalac session set settings shell show shutdown sbtn skip start tasks " +
        "test testOnly testQuick update version writeClasspath"
    for (
      word <- own.split(' ').toSeq ++ Seq(
        "~test",
        "hw/publishLocal",
        "sim/testOnly *",
        ";clean",
        "+compile",
        "",
        "--version",
        "-v"
      )
    )
      assert(mistyped(word) == ((0, "")), word)
    for (name <- Main.commands.map(_.name)) assert(mistyped(name) == ((0, "")), name)
  }

  test("only what simulates has a simulator and a compiler cache installed") {
    def needs(line: String): String = {
      val script = ". project/setup.sh; need() { echo \"$*\"; }; want() { echo \"$*\"; }; prepare \"$1\""
      Seq("bash", "-c", script, "bash", line).!!
    }
    for (
      line <- Seq("test", "sim/testOnly *", "render --scene teapot", "play pong", "play raster --engine pipeline");
      part <- Seq("verilator", "ccache")
    )
      assert(needs(line).contains(part), line)
    for (line <- Seq("quick", "render --engine model", "play raster", "play pong --engine model", "report"))
      assert(!needs(line).contains("verilator"), line)
  }
}
