package frustum.model.raster

import frustum.contract.raster.{Combine => CombineMode, RasterConfig, RenderState, TexelFormat, TextureRef}
import frustum.model.raster.fragment.{Blend, Combine, DepthStage, Fragment}
import frustum.model.raster.texture.{Divide, TextureUnit}

/** Bit-exact fragment stages with the buffers of one tile. Use: [[clear]], [[draw]] for every fragment of the
  * tile, [[resolve]]. Allocates nothing per fragment.
  *
  * @param texels
  *   texel memory, 16 bits a word
  */
final class FragmentModel(config: RasterConfig, texels: Array[Int]) {
  private val words = config.tileWidth * config.tileHeight
  private val divide = Divide.of(config)

  /** The tile, row by row from the top, RGB565. */
  val color: Array[Int] = new Array[Int](words)
  private val depth = new DepthStage(words)

  private var state: RenderState = _
  private var texture: TextureRef = _
  private var textured, replace, rgba4444 = false

  def clear(clearColor: Int): Unit = {
    java.util.Arrays.fill(color, clearColor)
    depth.clear()
  }

  /** Draws a fragment; true if it passed the alpha and depth tests. */
  def draw(f: Fragment, s: RenderState): Boolean = {
    if (s ne state) select(s)
    val at = f.y << config.tileLog2Width | f.x
    val z = Fragment.depth(f.z)
    val texel = if (textured) fetch(f) else -1
    val a = Combine.channel(texel & 31, if (replace && rgba4444) 255 else Fragment.channel(f.a))
    val pass = a >= s.alphaRef && depth(at, z, s)
    if (pass) {
      val r = Combine.channel((texel >> 16) & 31, if (replace) 255 else Fragment.channel(f.r))
      val g = Combine.channel((texel >> 10) & 63, if (replace) 255 else Fragment.channel(f.g))
      val b = Combine.channel((texel >> 5) & 31, if (replace) 255 else Fragment.channel(f.b))
      val source = r << 11 | g << 5 | b
      color(at) = if (s.blend) Blend(source, color(at), a) else source
    }
    pass
  }

  /** Copies the part of the tile that lies on the screen to `into`, RGB565, row by row from the top. */
  def resolve(tileX: Int, tileY: Int, into: Array[Int]): Unit = {
    val x = tileX * config.tileWidth
    val width = config.tileWidth.min(config.width - x)
    for (row <- 0 until config.tileHeight.min(config.height - tileY * config.tileHeight))
      System.arraycopy(
        color,
        row * config.tileWidth,
        into,
        (tileY * config.tileHeight + row) * config.width + x,
        width
      )
  }

  private def select(s: RenderState): Unit = {
    state = s
    textured = s.combine != CombineMode.ColorOnly
    replace = s.combine == CombineMode.Replace
    texture = s.texture.orNull
    rgba4444 = texture != null && texture.format == TexelFormat.Rgba4444
  }

  private def fetch(f: Fragment): Int = {
    val exponent = divide.exponent(f.q)
    val reciprocal = divide.reciprocal(f.q, exponent)
    val s =
      TextureUnit.index(divide.quotient(f.s, exponent, reciprocal), state.wrapS, texture.log2Width)
    val t = TextureUnit.index(
      divide.quotient(f.t, exponent, reciprocal),
      state.wrapT,
      texture.log2Height
    )
    val address = TextureUnit.address(s, t, texture.base, texture.log2Width)
    TextureUnit.decode(texels(address % texels.length), rgba4444)
  }
}
