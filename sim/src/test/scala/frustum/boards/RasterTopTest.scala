package frustum.boards

import frustum.boards.icebreaker.RasterTop
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.device.Tech
import frustum.harness.FrustumSim
import org.scalatest.funsuite.AnyFunSuite

import java.nio.file.Files

class RasterTopTest extends AnyFunSuite {
  test("a host at the SPI pins cannot be made to wait: what finds no room is dropped and counted") {
    val config = RasterConfig(width = 80, height = 64, maxVertices = 50, maxTriangles = 40, textureTexels = 1024)
    val top = FrustumSim.spinalConfig
      .copy(targetDirectory = Files.createTempDirectory("rasterTop").toString, verbose = false)
      .generateVerilog(RasterTop(config, Panel.Ili9341, coreMHz = 36, Tech.Generic))
      .toplevel
    assert(top.core.pipeline.link.framer.dropWhenFull)
  }
}
