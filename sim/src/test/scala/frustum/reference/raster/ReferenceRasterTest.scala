package frustum.reference.raster

import frustum.contract.raster.{
  Combine,
  DepthFunction,
  FramePass,
  RasterConfig,
  RenderState,
  TexelFormat,
  TextureRef,
  TileRegion,
  Wrap
}
import frustum.driver.raster.{DrawOptions, Driver}
import frustum.judge.Passes
import frustum.judge.Passes._
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class ReferenceRasterTest extends AnyFunSuite {
  private def draw(pass: FramePass, memory: Array[Int] = memory) = {
    val target = new ReferenceFrame(config)
    ReferenceRaster.drawPass(target, pass, memory, 0, _ => ())
    target
  }
  private def at(f: ReferenceFrame, x: Int, y: Int) = f.rgb888(y * config.width + x)

  test("a quad of one pixel a texel shows the texture, its first row at the bottom") {
    val shown = draw(pass(Seq(textured), quad(8, 8, 24, 24): _*)).rgb565
    for (y <- 0 until 16; x <- 0 until 16)
      assert(shown((8 + y) * 64 + 8 + x) == upload.texels((15 - y) * 16 + x), s"($x, $y)")
    assert(shown(8 * 64 + 7) == 0 && shown(24 * 64 + 8) == 0)
  }

  test("a floor in perspective has the coordinates of the points that the rays meet") {
    val scene = Scenes.floor
    val config = RasterConfig(width = 80, height = 60)
    val frame =
      Driver.prepare(scene, scene.camera, DrawOptions(None, cullBack = false, Wrap.Repeat, 0), config, 0)
    val focal = 1 / scala.math.tan(scala.math.toRadians(30))
    var seen = 0
    ReferenceRaster.drawEndToEnd(
      frame,
      f => {
        // The ray (x, y, -1) meets the plane y = -1 at z = -1 / y; 8 repeats over x -50..50 and z -1..-100.
        val rayX = ((f.x + 0.5) / 80 * 2 - 1) * 80 / 60 / focal
        val z = -1 / ((1 - (f.y + 0.5) / 60 * 2) / focal)
        assert((f.at.s - (rayX * z + 50) / 100 * 8).abs < 1e-6, s"s at (${f.x}, ${f.y})")
        assert((f.at.t - (z - 1) / 99 * 8).abs < 1e-6, s"t at (${f.x}, ${f.y})")
        seen += 1
      }
    )
    assert(seen > 1500)
  }

  test("wrap modes") {
    val expected = Seq(
      Wrap.Repeat -> Seq(6, 7, 0, 1, 7, 0, 7, 0),
      Wrap.Clamp -> Seq(0, 0, 0, 1, 7, 7, 7, 7),
      Wrap.Mirror -> Seq(1, 0, 0, 1, 7, 7, 0, 0)
    )
    for ((mode, texels) <- expected; (texel, i) <- Seq(-2, -1, 0, 1, 7, 8, 15, 16).zipWithIndex)
      assert(Sampler.wrap(texel.toLong, 8, mode) == texels(i), s"$mode $texel")
  }

  test("replace and modulate, with and without alpha in the texture") {
    val memory4444 = Array.fill(32768)(0x84c9)
    val rgba = RenderState(Some(TextureRef(0, 3, 3, TexelFormat.Rgba4444)), combine = Combine.Replace)
    val corner = Attributes(0.5, 0.5, 0, 51, 102, 255, 128)
    def color(s: RenderState, m: Array[Int]) = Shading.color(s, m, corner, Some((4, 4)))
    assert(color(rgba, memory4444) == Rgba(8 * 17, 4 * 17, 12 * 17, 9 * 17))
    val expected = Rgba(8 * 17.0 * 51 / 255, 4 * 17.0 * 102 / 255, 12 * 17, 9 * 17.0 * 128 / 255)
    assert(color(rgba.copy(combine = Combine.Modulate), memory4444) == expected)
    val rgb = rgba.copy(texture = Some(TextureRef(0, 3, 3, TexelFormat.Rgb565)))
    assert(color(rgb, Array.fill(32768)(0xffff)) == Rgba(255, 255, 255, 128))
    assert(color(rgb.copy(combine = Combine.Modulate), Array.fill(32768)(0xffff)) == Rgba(51, 102, 255, 128))
    assert(color(rgb.copy(combine = Combine.ColorOnly), memory4444) == Rgba(51, 102, 255, 128))
  }

  test("nearer wins in either order, the write mask and the functions hold") {
    val plain = RenderState()
    val (red, green) = (0xff0000ff, 0x00ff00ff)
    def two(a: RenderState, b: RenderState, za: Int, zb: Int) =
      at(draw(pass(Seq(a, b), quad(0, 0, 8, 8, 0, za, red) ++ quad(0, 0, 8, 8, 1, zb, green): _*)), 3, 3)
    assert(two(plain, plain, 10, 20) == 0xff0000 && two(plain, plain, 20, 10) == 0x00ff00)
    assert(two(plain, plain, 10, 10) == 0xff0000)
    assert(two(plain.copy(depthWrite = false), plain, 10, 20) == 0x00ff00)
    assert(two(plain, plain.copy(depth = DepthFunction.Always), 10, 20) == 0x00ff00)
    assert(two(plain, plain.copy(depth = DepthFunction.Never), 20, 10) == 0xff0000)
  }

  test("blending weighs by source alpha, the alpha test drops what is below its reference") {
    val blended = RenderState(blend = true)
    val drawn = draw(pass(
      Seq(RenderState(), blended),
      quad(0, 0, 8, 8, 0, 20, 0xff0000ff) ++ quad(0, 0, 8, 8, 1, 10, 0x00ff0033): _*
    ))
    assert(at(drawn, 3, 3) == 0xcc3300)
    for ((alpha, passes) <- Seq(0x80 -> true, 0x7a -> false))
      assert((at(
        draw(pass(Seq(RenderState(alphaRef = 16)), quad(0, 0, 8, 8, rgba = 0xffffff00 | alpha): _*)),
        3,
        3
      ) != 0) == passes)
  }

  test("passes of different regions make up one frame") {
    val whole = Passes.random(5, 40)
    val halves =
      Seq(TileRegion(0, 0, 0, 2), TileRegion(1, 0, Passes.config.tilesX - 1, 2)).map(r => whole.copy(region = r))
    assert(
      ReferenceRaster.draw(frame(whole)).rgb888 sameElements ReferenceRaster.draw(frame(halves: _*)).rgb888
    )
  }
}
