package frustum.engine

import frustum.contract.voxel.{LeapField, VoxelConfig, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.driver.voxel.VoxelView
import frustum.engine.pong.PongEngines
import frustum.engine.raster.RasterEngines
import frustum.engine.voxel.{VoxelEngines, VoxelSetting}
import frustum.scene.Hills
import frustum.driver.linear.Vector3
import org.scalatest.funsuite.AnyFunSuite

class EngineTableTest extends AnyFunSuite {
  test("the hardware at its pins is every table's default") {
    for (table <- Seq(RasterEngines, VoxelEngines, PongEngines))
      assert(table.default.name == "hardware" && table.default.kind == EngineKind.Board)
  }

  test("a former name is still taken and not told, another one is refused with the names that there are") {
    assert(VoxelEngines.byName("small") eq VoxelEngines.byName("compact"))
    val refused = intercept[IllegalArgumentException](VoxelEngines.byName("gpu"))
    assert(refused.getMessage == "'gpu' is none of hardware, pipeline, compact, model, reference")
  }

  test("a work may depend on the frame before") {
    val config = VoxelConfig(WorldSize(16, 16, 16), 32, 24, LeapField.Quadrants, 8)
    val setting = VoxelSetting(config, Blocks.assets, Hills(config.size, 1), highlight = false, 1)
    var drawn = 0
    val views = Iterator.continually(()).takeWhile(_ => drawn < 3).map { _ =>
      VoxelView(Vector3(8, 8, 12), 30.0 * drawn, -20, 24)
    }
    VoxelEngines.byName("model").make(setting).draw(views) { frame =>
      assert(frame.picture.length == config.pixels)
      drawn += 1
    }
    assert(drawn == 3)
  }
}
