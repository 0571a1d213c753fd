package frustum.boards

import frustum.boards.flow.{Ice40Flow, Ice40Tools, Nextpnr, Tool}
import frustum.harness.Synthesised
import java.nio.file.{Files, Path, Paths}
import org.scalatest.funsuite.AnyFunSuite

/** The whole flow on a small design. Only with native tools: YoWASP needs half a minute to prepare itself. */
class FlowTest extends AnyFunSuite {
  private def native: Ice40Tools = {
    val missing = Seq("yosys", "nextpnr-ice40", "icepack").filter(Tool.onPath(_).isEmpty)
    if (missing.nonEmpty) cancel(s"no native ${missing.mkString(", ")}; the bitstream command fetches its own")
    Ice40Tools.find(_ => cancel("the native tools are too old"))
  }

  private def scratch(): Path = {
    val parent = Paths.get("tmp")
    Files.createDirectories(parent)
    Files.createTempDirectory(parent, "flow")
  }

  private def pins(directory: Path): String = {
    val file = directory.resolve("blink.pcf")
    Files.writeString(file, "set_io clk 35\nset_io led 11\nset_io resetn 46\nset_io sck 4\n")
    file.toString
  }

  test("a small design becomes a bitstream with its figures", Synthesised) {
    val tools = native
    val directory = scratch()
    val top = BlinkTop.table(36, pins(directory))
    val report = new Ice40Flow(tools).run(top, 1 to 2, directory, println(_), Nextpnr.Static)
    assert(report.fits && report.meetsTarget, report.shortfalls)
    assert(Files.size(directory.resolve("blink.bin")) > 100000)
    val json = report.json("1")
    assert(json("spram").num == 1 && json("ebr").num == 1 && json("dsp").num == 0)
    assert(json("clockMHz")("seeds").arr.length == 2)
    assert(json("clockMHz")("min").num >= 36)
  }

  test("a target out of reach is reported, not hidden", Synthesised) {
    val tools = native
    val directory = scratch()
    val top = BlinkTop.table(180, pins(directory))
    val report = new Ice40Flow(tools).run(top, 1 to 1, directory, _ => (), Nextpnr.Heap)
    assert(report.fits && !report.meetsTarget)
    assert(report.json("1")("meetsTarget") == ujson.False)
  }
}
