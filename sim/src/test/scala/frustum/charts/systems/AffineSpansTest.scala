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

  private def differ(scene: String, length: Int): Int = {
    val f = frame(scene)
    val (exact, spans) = (picture(f, new RasterModel(config)), picture(f, new AffineSpans(config, length)))
    exact.zip(spans).count { case (a, b) => a != b }
  }

  test("longer spans are farther from the model's picture; untextured ones are the same") {
    assert(differ("cube", 8) > 0 && differ("cube", 16) > differ("cube", 8) && differ("cube", 2) < differ("cube", 8))
    assert(differ("teapot", 16) == 0)
  }

  test("a level floor lies at one depth along each row, so that spans along rows are as good as exact") {
    assert(differ("floor", 16) < 10) // of 9,216 pixels: a line between quotients that were cut
  }
}
