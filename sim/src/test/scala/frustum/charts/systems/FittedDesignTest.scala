package frustum.charts.systems

import frustum.contract.raster.{PlaneFormats, RasterConfig}
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

class FittedDesignTest extends AnyFunSuite {
  private val base = RasterConfig()
  private val options = SystemConfiguration.plain(Scenes.byName("cube"))
  private val report =
    """{"budget": {"texelsWrongPercent": 0.5}, "logicCells": 3365, "clockMHz": 40.5,
      |"configuration": {"width": 240, "height": 320,
      |"textureTexels": 4096, "maxVertices": 64, "maxTriangles": 32, "positionBits": 9, "repeatBits": 0, "ratioBits": 1,
      |"clearColor": 8582, "constant": [], "fixed": {"blend": {"mask": 1, "value": 0}},
      |"coordinate": 4, "depth": 0, "color": 0,
      |"inverse": 9, "cullBack": true, "depthTest": false}}""".stripMargin

  test("the configuration, the driver's options and the placed figures come from the report") {
    val folder = Files.createTempDirectory("fit")
    Files.writeString(folder.resolve("cube.json"), report)
    val f = FittedDesign.read("cube", base, options, folder).get
    val c = f.configuration
    assert(c.setting == "within 0.5 % of texels" && c.options.cullBack && !c.options.depthTest)
    assert(c.config.formats == PlaneFormats(coordinate = 4, inverse = 9) && c.config.clearColor.contains(8582))
    assert(c.config.fixed.neverBlends && f.placed.map(p => (p.cells, p.clockMHz)).contains((Some(3365), Some(40.5))))
    assert(FittedDesign.read("teapot", base, options, folder).isEmpty)
    assert(FittedDesign.read("cube", RasterConfig(width = 96, height = 96), options, folder).isEmpty)
    Files.writeString(folder.resolve("cube.json"), "{}")
    assert(FittedDesign.read("cube", base, options, folder).isEmpty)
  }
}
