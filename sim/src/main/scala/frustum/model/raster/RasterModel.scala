package frustum.model.raster

import frustum.contract.raster.{Combine, FramePass, RasterConfig, RenderState}
import frustum.model.raster.fragment.Fragment
import frustum.model.raster.texture.{Divide, TextureUnit}

/** Bit-exact raster pipeline: a pass to pixels, as [[frustum.raster.RasterPipeline]] draws it. */
final class RasterModel(config: RasterConfig) extends PassRenderer {
  private val divide = Divide.of(config)

  def draw(pass: FramePass, memory: Array[Int], into: Array[Int], probe: Option[FragmentProbe]): Unit = {
    val stages = new FragmentModel(config, memory)
    val f = new Fragment
    Rasterizer(config).draw(
      pass,
      new FragmentSink {
        private var originX, originY = 0
        def tile(tileX: Int, tileY: Int): Unit = {
          originX = tileX * config.tileWidth
          originY = tileY * config.tileHeight
          stages.clear(pass.clearColor)
        }
        def fragment(
            n: Int,
            state: RenderState,
            x: Int,
            y: Int,
            s: Int,
            t: Int,
            q: Int,
            z: Int,
            r: Int,
            g: Int,
            b: Int,
            a: Int
        ): Unit = {
          f.x = x; f.y = y; f.s = s; f.t = t; f.q = q; f.z = z; f.r = r; f.g = g; f.b = b; f.a = a
          val drawn = stages.draw(f, state)
          probe.foreach { p =>
            val texel = if (state.combine == Combine.ColorOnly) 0 else TextureUnit.texel(divide, s, t, q, state)
            p.fragment(n, originX + x, originY + y, texel & 255, texel >> 8, Fragment.depth(z), drawn)
          }
        }
        def tileEnd(tileX: Int, tileY: Int): Unit = stages.resolve(tileX, tileY, into)
      }
    )
  }
}
