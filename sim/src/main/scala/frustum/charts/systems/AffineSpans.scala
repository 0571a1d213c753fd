package frustum.charts.systems

import frustum.contract.raster.{Combine, FramePass, RasterConfig, RenderState}
import frustum.model.raster.fragment.Fragment
import frustum.model.raster.texture.{Divide, TextureUnit}
import frustum.model.raster.{FragmentModel, FragmentProbe, FragmentSink, PassRenderer, Rasterizer}

/** The model with affine spans in place of a division for each pixel. Texture coordinates are divided at the first and
  * the last pixel of a triangle's row in a tile and at every `length`th between, and interpolated from one to the next
  * (Abrash, "Graphics Programming Black Book", chapter 70). The library has no such hardware: this is the method's
  * error alone.
  */
final class AffineSpans(config: RasterConfig, length: Int) extends PassRenderer {
  require(length >= 2, s"spans of $length pixels: at least 2")
  private val divide = Divide.of(config)

  def draw(pass: FramePass, memory: Array[Int], into: Array[Int], probe: Option[FragmentProbe]): Unit = {
    val stages = new FragmentModel(config, memory)
    Rasterizer(config).draw(
      pass,
      new FragmentSink {
        private var originX, originY = 0
        private var row = Vector.empty[(Int, RenderState, Fragment)]

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
          if (row.headOption.exists { case (m, _, f) => m != n || f.y != y }) finish()
          val f = new Fragment
          f.x = x; f.y = y; f.s = s; f.t = t; f.q = q; f.z = z; f.r = r; f.g = g; f.b = b; f.a = a
          row :+= ((n, state, f))
        }

        private def finish(): Unit = {
          val quotients = row.map { case (_, _, f) => (divide(f.s, f.q), divide(f.t, f.q)) }
          val us = AffineSpans.between(quotients.map(_._1), length)
          val vs = AffineSpans.between(quotients.map(_._2), length)
          for (((n, state, f), i) <- row.zipWithIndex) {
            f.q = 1 << 30 // 1/2, so that the division gives the coordinate back
            f.s = us(i) << 5
            f.t = vs(i) << 5
            val drawn = stages.draw(f, state)
            probe.foreach { p =>
              val texel = if (state.combine == Combine.ColorOnly) 0 else TextureUnit.texel(divide, f.s, f.t, f.q, state)
              p.fragment(n, originX + f.x, originY + f.y, texel & 255, texel >> 8, Fragment.depth(f.z), drawn)
            }
          }
          row = Vector.empty
        }

        def tileEnd(tileX: Int, tileY: Int): Unit = { finish(); stages.resolve(tileX, tileY, into) }
      }
    )
  }
}

object AffineSpans {

  /** The values at the first, the last and every `length`th place as they are, those between on lines. */
  def between(values: IndexedSeq[Int], length: Int): IndexedSeq[Int] = values.indices.map { i =>
    val from = i / length * length
    val to = (from + length).min(values.length - 1)
    if (to == from) values(i)
    else values(from) + ((values(to) - values(from)).toLong * (i - from) / (to - from)).toInt
  }
}
