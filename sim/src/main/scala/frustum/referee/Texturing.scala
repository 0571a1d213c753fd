package frustum.referee

import frustum.contract.raster.Wrap
import frustum.driver.scene.TextureImage
import scala.math.{floorMod, round}

/** A colour, components 0..255, alpha 0..1. */
final case class Color(r: Double, g: Double, b: Double, a: Double) {
  def rgb: Seq[Double] = Seq(r, g, b)

  /** Source alpha over one minus source alpha (OpenGL 2.1, 4.1.8). */
  def over(below: Color): Color = {
    def mix(s: Double, d: Double) = s * a + d * (1 - a)
    Color(mix(r, below.r), mix(g, below.g), mix(b, below.b), 1)
  }

  /** 0xRRGGBB, rounded to nearest. */
  def word: Int = rgb.foldLeft(0)((w, c) => w << 8 | round(c.max(0).min(255)).toInt)
}

object Color {
  def ofWord(argb: Int): Color =
    Color((argb >> 16 & 255).toDouble, (argb >> 8 & 255).toDouble, (argb & 255).toDouble, (argb >>> 24) / 255.0)
}

/** Nearest sampling (OpenGL 2.1, 3.8.7 and 3.8.8): texel i = floor(u) with u = s * width, row j from the bottom row up.
  */
object Texturing {

  /** The texel that index `i` of a side of `size` stands for: GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT. */
  def wrapped(i: Long, size: Int, mode: Wrap): Int = mode match {
    case Wrap.Repeat => floorMod(i, size.toLong).toInt
    case Wrap.Clamp  => i.max(0L).min(size - 1L).toInt
    case Wrap.Mirror =>
      val along = floorMod(i, size.toLong).toInt
      if (floorMod(i, 2L * size) < size) along else size - 1 - along
  }

  /** Colour of texel (i, j); pictures are stored from the top row down. */
  def texel(picture: TextureImage, i: Int, j: Int): Color = {
    val word = picture.argb((picture.height - 1 - j) * picture.width + i)
    if (picture.hasAlpha) Color.ofWord(word) else Color.ofWord(word | 0xff000000)
  }
}
