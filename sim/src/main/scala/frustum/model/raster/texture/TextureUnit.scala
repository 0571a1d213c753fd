package frustum.model.raster.texture

import frustum.contract.raster.{RenderState, Wrap}

/** Bit-exact nearest texel: wrapping, address, decoding. */
object TextureUnit {

  /** Texel along one axis of 2^log2 texels, from a coordinate in repeats with 17 fraction bits. */
  def index(coordinate: Int, wrap: Wrap, log2: Int): Int = {
    val fraction = (coordinate >> 10) & 127
    val integer = coordinate >> 17
    val wrapped = wrap match {
      case Wrap.Repeat => fraction
      case Wrap.Mirror => if ((integer & 1) != 0) 127 - fraction else fraction
      case Wrap.Clamp  => if (integer < 0) 0 else if (integer > 0) 127 else fraction
    }
    wrapped >> (7 - log2)
  }

  /** The texel read for a fragment, `texelT << 8 | texelS`; the state must have a texture. */
  def texel(divide: Divide, s: Int, t: Int, q: Int, state: RenderState): Int = {
    val texture = state.texture.get
    val exponent = divide.exponent(q)
    val reciprocal = divide.reciprocal(q, exponent)
    index(divide.quotient(t, exponent, reciprocal), state.wrapT, texture.log2Height) << 8 |
      index(divide.quotient(s, exponent, reciprocal), state.wrapS, texture.log2Width)
  }

  def address(texelS: Int, texelT: Int, base: Int, log2Width: Int): Int =
    ((base << 6) + ((texelT << log2Width) | texelS)) & 0x7fff

  /** Red 5, green 6, blue 5 and alpha 5 bits at bits 16, 10, 5 and 0 of the result. */
  def decode(word: Int, rgba4444: Boolean): Int =
    if (!rgba4444) (word & 0xffff) << 5 | 31
    else {
      def five(n: Int) = n << 1 | n >> 3
      val g = (word >> 8) & 15
      five((word >> 12) & 15) << 16 | (g << 2 | g >> 2) << 10 | five((word >> 4) & 15) << 5 | five(word & 15)
    }
}
