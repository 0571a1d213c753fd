package frustum.charts.systems

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.model.raster.{PassRenderer, RasterModel}
import frustum.reference.raster.ReferenceRaster
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class AffineSpansTest extends AnyFunSuite {
  private val config = RasterConfig(width = 96, height = 96)

  private def frame(scene: String): PreparedFrame = {
    val s = Scenes.byName(scene)
    Driver.prepare(s, s.camera, SystemConfiguration.plain(s), config, 0)
  }
  private def picture(f: PreparedFrame, renderer: PassRenderer): Seq[Int] = {
    val image = new Array[Int](config.width * config.height)
    f.passes.foreach(renderer.draw(_, ReferenceRaster.texelMemory(f.textures), image, None))
    image.toSeq
  }

  test("values between lie on lines from one division to the next") {
    assert(AffineSpans.between(Vector(0, 9, 8, 9, 16, 9, 9, 40), 4) == Vector(0, 4, 8, 12, 16, 24, 32, 40))
    assert(AffineSpans.between(Vector(7), 4) == Vector(7))
    assert(AffineSpans.between(Vector(-8, 5, -2), 8) == Vector(-8, -5, -2))
  }

  test("a division for each pixel is the model; longer spans are other pictures, untextured ones the same") {
    val floor = frame("floor")
    val exact = picture(floor, new RasterModel(config))
    def differ(length: Int) = exact.zip(picture(floor, new AffineSpans(config, length))).count { case (a, b) => a != b }
    assert(differ(8) > 0 && differ(16) > differ(8) && differ(2) < differ(8))
    val teapot = frame("teapot")
    assert(picture(teapot, new RasterModel(config)) == picture(teapot, new AffineSpans(config, 16)))
  }
}
