package frustum

import org.scalatest.funsuite.AnyFunSuite
import scala.sys.process._

/** What the launcher finds a command to need, with `install` replaced by a line that names the packages. */
class SetupTest extends AnyFunSuite {
  private def wants(line: String, path: String = "/nonexistent"): String = {
    val script =
      s"""set -u; . project/setup.sh; install() { echo "$$*"; }; command() { PATH='$path' builtin command "$$@"; }
         |python3() { return 1; }; ldconfig() { :; }; grep() { return 1; }; id() { echo 0; }
         |prepare '$line'""".stripMargin
    Seq("bash", "-c", script).!!.trim
  }

  test("help and elaboration need nothing") {
    for (
      line <- Seq("render --help", "bitstream --help", "verilog icebreaker-raster", "hw/publishLocal", "scalafmtAll")
    )
      assert(wants(line) == "", line)
  }

  test("simulation needs Verilator, make and g++") {
    for (
      line <- Seq("demo", "render --scene teapot", "bench raster", "pong", "voxel --seed 2", "play voxel") ++
        Seq("fit --scene cube", "fit --scene cube --no-synthesis", "mutate blend", "test", "sim/testOnly frustum.X")
    )
      assert(wants(line).linesIterator.next() == "verilator make g++", line)
    for (line <- Seq("render --scene cube --engine model", "voxel --engine model", "chart depth --no-synthesis"))
      assert(wants(line) == "", line)
  }

  test("a bitstream needs Python's venv, and nothing of a simulator") {
    for (line <- Seq("bitstream icebreaker-raster --seeds 3", "chart depth"))
      assert(wants(line) == "python3 python3-venv", line)
  }

  test("without root the message names the package, in one line, with exit code 2") {
    val script = ". project/setup.sh; id() { echo 1000; }; apt-get() { :; }; need frustum-no-such-program verilator"
    val lines = collection.mutable.Buffer[String]()
    val code = Seq("bash", "-c", script).!(ProcessLogger(lines += _, lines += _))
    assert(code == 2)
    assert(lines.size == 1 && lines.head.startsWith("error: ") && lines.head.contains("apt-get install verilator"))
  }
}
