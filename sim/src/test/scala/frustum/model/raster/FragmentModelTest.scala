package frustum.model.raster

import frustum.contract.raster.{Combine, DepthFunction, RasterConfig, RenderState, TexelFormat, TextureRef}
import frustum.harness.ThreadTime
import frustum.model.raster.fragment.{Fragment => FragmentValues}
import org.scalatest.funsuite.AnyFunSuite

class FragmentModelTest extends AnyFunSuite {
  private val config = RasterConfig(tileLog2Width = 5)

  test("a fragment is drawn, tested and resolved") {
    val model = new FragmentModel(config, new Array[Int](config.textureTexels))
    val image = new Array[Int](config.width * config.height)
    val state = RenderState(depth = DepthFunction.Less)
    val f = new FragmentValues
    f.x = 3; f.y = 2; f.q = 1 << 30; f.z = 1000 << 15; f.r = 255 << 7; f.a = 255 << 7
    model.clear(0x1234)
    assert(model.draw(f, state) && !model.draw(f, state))
    model.resolve(1, 1, image)
    assert(image((16 + 2) * config.width + 32 + 3) == 0xf800)
    assert(image((16 + 2) * config.width + 32 + 4) == 0x1234)
  }

  test("the model draws a million pixels a second at least") {
    val model = new FragmentModel(config, new Array[Int](config.textureTexels))
    val state = RenderState(
      Some(TextureRef(0, 6, 6, TexelFormat.Rgb565)),
      combine = Combine.Modulate,
      blend = true,
      depth = DepthFunction.Always
    )
    val f = new FragmentValues
    def draw(n: Int): Unit = for (i <- 0 until n) {
      f.x = i & 31; f.y = (i >> 5) & 15; f.s = i << 8; f.t = i << 4; f.q = (1 << 30) + i; f.a = i & 0x7fff
      model.draw(f, state)
    }
    draw(1000000)
    val (seconds, _) = ThreadTime.of(draw(4000000))
    val rate = 4e6 / seconds
    info(f"$rate%.0f pixels/s")
    assert(rate > 1e6)
  }
}
