package frustum.reference.raster

import frustum.contract.raster.{TexelFormat, TextureRef, Wrap}

/** A colour; components 0..255. */
final case class Rgba(r: Double, g: Double, b: Double, a: Double)

/** Nearest sampling as OpenGL defines it: texel = floor(coordinate * size), then the wrap mode. */
object Sampler {

  /** Index of the texel after wrapping. Mirror turns every other repeat round. */
  def wrap(texel: Long, size: Int, mode: Wrap): Int = mode match {
    case Wrap.Repeat => scala.math.floorMod(texel, size.toLong).toInt
    case Wrap.Clamp  => texel.max(0L).min(size - 1L).toInt
    case Wrap.Mirror =>
      val m = scala.math.floorMod(texel, 2L * size).toInt
      if (m < size) m else 2 * size - 1 - m
  }

  /** Colour of texel (s, t), both already wrapped; t counts from the bottom row. RGB565 is opaque. */
  def texel(memory: Array[Int], texture: TextureRef, s: Int, t: Int): Rgba = {
    val word = memory((texture.base * 64 + t * texture.width + s) % memory.length)
    texture.format match {
      case TexelFormat.Rgb565   => rgb565(word)
      case TexelFormat.Rgba4444 =>
        def nibble(shift: Int) = (word >> shift & 15) * 17.0
        Rgba(nibble(12), nibble(8), nibble(4), nibble(0))
    }
  }

  /** The opaque colour that an RGB565 word stands for. */
  def rgb565(word: Int): Rgba =
    Rgba((word >> 11 & 31) * 255 / 31.0, (word >> 5 & 63) * 255 / 63.0, (word & 31) * 255 / 31.0, 255)
}
