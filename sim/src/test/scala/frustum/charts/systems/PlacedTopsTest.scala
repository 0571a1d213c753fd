package frustum.charts.systems

import frustum.boards.icebreaker.IcebreakerTops
import frustum.contract.raster.{PlaneFormats, RasterConfig}
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Path}

class PlacedTopsTest extends AnyFunSuite {
  private def folder(): Path = Files.createTempDirectory("placed")
  private val report =
    """{"fits": true, "logicCells": 4974, "clockMHz": {"min": 39.4, "max": 41, "seeds": [39.4, 41]}}"""
  private val top = IcebreakerTops.rasterOf("system", RasterConfig())

  test("the digest is of the design: comments, which name the commit, do not count, a changed line does") {
    val verilog = "// Git hash  : 1234\nmodule m;\nendmodule\n"
    assert(PlacedTops.digest(verilog) == PlacedTops.digest(verilog.replace("1234", "5678")))
    assert(PlacedTops.digest(verilog) != PlacedTops.digest(verilog.replace("module m", "module n")))
  }

  test("a figure is found again for the same Verilog, and not for another configuration") {
    val cache = folder()
    val tops = new PlacedTops(None, cache, folder())
    val (nothing, digest) = tops(top)
    assert(nothing.isEmpty)
    Files.writeString(cache.resolve(s"placed-$digest.json"), report)
    val (found, again) = tops(IcebreakerTops.rasterOf("other-name", RasterConfig()))
    assert(again == digest && found.map(p => (p.cells, p.clockMHz)).contains((Some(4974), Some(39.4))))
    val narrow = RasterConfig(formats = PlaneFormats(coordinate = 4))
    assert(tops(IcebreakerTops.rasterOf("system", narrow))._1.isEmpty)
  }

  test("a report of `bitstream` counts if it was made from the same Verilog, which lies beside it") {
    val (cache, reports) = (folder(), folder())
    val build = Files.createDirectories(reports.resolve("system.build"))
    Files.writeString(reports.resolve("system.json"), report)
    val tops = new PlacedTops(None, cache, reports)
    assert(tops(top)._1.isEmpty)
    top.writeVerilog(build.toString)
    assert(tops(top)._1.flatMap(_.clockMHz).contains(39.4))
    Files.writeString(build.resolve("system.v"), "module changed; endmodule\n")
    assert(tops(top)._1.isEmpty)
  }

  test("what does not fit has cells and no clock; what cannot be read is unknown") {
    val file = folder().resolve("r.json")
    Files.writeString(file, """{"fits": false, "logicCells": 5600}""")
    assert(PlacedTops.read(file, "test").contains(Placed(Some(5600), None, "test")))
    Files.writeString(file, "{")
    assert(PlacedTops.read(file, "test").isEmpty)
  }

  test("cycles are kept by the hardware and the commands, and simulated only where that is allowed") {
    val cache = folder()
    val scene = frustum.scene.Scenes.byName("cube")
    val config = RasterConfig(width = 96, height = 96)
    def frame(turn: Double) = frustum.driver.raster.Driver.prepare(
      scene,
      scene.camera,
      SystemConfiguration.plain(scene).copy(turnDegrees = turn),
      config,
      0
    )
    var runs = 0
    val cycles = new SystemCycles(_ => { runs += 1; 1000L + runs }, cache)
    assert(cycles(frame(0), "a", may = false).isEmpty && runs == 0)
    assert(cycles(frame(0), "a", may = true).contains(1001L) && cycles(frame(0), "a", may = false).contains(1001L))
    assert(cycles(frame(0), "b", may = true).contains(1002L) && cycles(frame(30), "a", may = true).contains(1003L))
  }
}
