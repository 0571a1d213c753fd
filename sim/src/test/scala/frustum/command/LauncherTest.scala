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

  test("only what simulates has a simulator and a compiler cache installed") {
    def needs(line: String): String = {
      val script = ". project/setup.sh; need() { echo \"$*\"; }; want() { echo \"$*\"; }; prepare \"$1\""
      Seq("bash", "-c", script, "bash", line).!!
    }
    for (line <- Seq("test", "sim/testOnly *", "render --scene teapot"); part <- Seq("verilator", "ccache"))
      assert(needs(line).contains(part), line)
    for (line <- Seq("quick", "render --engine model")) assert(!needs(line).contains("verilator"), line)
  }
}
