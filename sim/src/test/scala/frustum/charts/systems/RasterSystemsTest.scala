package frustum.charts.systems

import frustum.contract.raster.{PlaneFormats, RasterConfig}
import frustum.driver.raster.Driver
import frustum.harness.Simulated
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class RasterSystemsTest extends AnyFunSuite with Simulated {
  test("a frame takes as many cycles with fewer bits of its planes, so that one simulation stands for all") {
    val narrow = RasterConfig(width = 96, height = 80, formats = PlaneFormats(coordinate = 8, depth = 19, color = 10))
    for (name <- Seq("cube", "teapot")) {
      val scene = Scenes.byName(name)
      val cycles = Seq(narrow, RasterSystems.timed(narrow)).map { config =>
        SystemCycles.simulation(Driver.prepare(scene, scene.camera, SystemConfiguration.plain(scene), config, 0))
      }
      assert(cycles.distinct.length == 1, s"$name: $cycles")
    }
  }
}
