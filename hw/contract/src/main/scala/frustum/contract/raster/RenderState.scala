package frustum.contract.raster

/** How texture coordinates outside 0..1 are mapped back into the texture. */
sealed abstract class Wrap(val code: Int)
object Wrap {
  case object Repeat extends Wrap(0)
  case object Clamp extends Wrap(1)
  case object Mirror extends Wrap(2)
  val all: Seq[Wrap] = Seq(Repeat, Clamp, Mirror)
}

/** Texel formats: 16 bits each, red in the most significant bits. */
sealed abstract class TexelFormat(val code: Int)
object TexelFormat {
  case object Rgb565 extends TexelFormat(0)
  case object Rgba4444 extends TexelFormat(1)
}

/** How texel and vertex colour make the fragment's colour (OpenGL's texture environment). */
sealed abstract class Combine(val code: Int)
object Combine {
  case object ColorOnly extends Combine(0)
  case object Replace extends Combine(1)
  case object Modulate extends Combine(2)
}

/** OpenGL's eight depth functions as the set of {less, equal, greater} that passes. */
final case class DepthFunction(less: Boolean, equal: Boolean, greater: Boolean) {
  def code: Int = (if (less) 1 else 0) | (if (equal) 2 else 0) | (if (greater) 4 else 0)
  def passes(fragment: Int, stored: Int): Boolean =
    if (fragment < stored) less else if (fragment == stored) equal else greater
}
object DepthFunction {
  val Never = DepthFunction(false, false, false)
  val Less = DepthFunction(true, false, false)
  val LessEq = DepthFunction(true, true, false)
  val Always = DepthFunction(true, true, true)
  def decode(code: Int): DepthFunction = DepthFunction((code & 1) != 0, (code & 2) != 0, (code & 4) != 0)
}

/** A texture in texel memory: `base` in units of 64 texels, sides powers of two from 8 to 128. */
final case class TextureRef(base: Int, log2Width: Int, log2Height: Int, format: TexelFormat) {
  require(base >= 0 && base < 512, s"texture base $base is outside 0..511 (units of 64 texels)")
  require(log2Width >= 3 && log2Width <= 7, s"texture width 2^$log2Width is outside 8..128")
  require(log2Height >= 3 && log2Height <= 7, s"texture height 2^$log2Height is outside 8..128")
  def width: Int = 1 << log2Width
  def height: Int = 1 << log2Height
}

/** Everything the fragment stages need to know of a triangle, one 32-bit word.
  *
  * @param alphaRef a fragment passes the alpha test when its five-bit alpha is at least this; 0 turns the test off
  * @param blend    source-alpha blending: source * alpha + destination * (1 - alpha)
  */
final case class RenderState(
    texture: Option[TextureRef] = None,
    wrapS: Wrap = Wrap.Repeat,
    wrapT: Wrap = Wrap.Repeat,
    combine: Combine = Combine.ColorOnly,
    depth: DepthFunction = DepthFunction.Less,
    depthWrite: Boolean = true,
    blend: Boolean = false,
    alphaRef: Int = 0
) {
  require(alphaRef >= 0 && alphaRef < 32, s"alpha reference $alphaRef is outside 0..31")
  require(texture.isDefined || combine == Combine.ColorOnly, s"$combine needs a texture")

  /** Two 16-bit words of the wire. */
  def words: Seq[Int] = {
    val t = texture.getOrElse(TextureRef(0, 3, 3, TexelFormat.Rgb565))
    Seq(
      t.base | (t.log2Width - 3) << 9 | (t.log2Height - 3) << 12 | t.format.code << 15,
      wrapS.code | wrapT.code << 2 | combine.code << 4 | depth.code << 6 |
        (if (depthWrite) 1 << 9 else 0) | (if (blend) 1 << 10 else 0) | alphaRef << 11
    )
  }
}

object RenderState {
  val Count = 16
}
