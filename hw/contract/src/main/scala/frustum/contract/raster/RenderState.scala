package frustum.contract.raster

import frustum.contract.Field

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
  val all: Seq[TexelFormat] = Seq(Rgb565, Rgba4444)
}

/** How texel and vertex colour make the fragment's colour (OpenGL's texture environment). */
sealed abstract class Combine(val code: Int)
object Combine {
  case object ColorOnly extends Combine(0)
  case object Replace extends Combine(1)
  case object Modulate extends Combine(2)
  val all: Seq[Combine] = Seq(ColorOnly, Replace, Modulate)
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
object TextureRef {

  /** log2 of the least side; the state's word has the difference from it. */
  val LeastLog2 = 3
}

/** Everything that the fragment stages need of a triangle; on the wire a [[RenderStateLayout]].
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

  /** The words of the wire; without a texture, the fields of a texture are 0. */
  def words: Seq[Int] = {
    import RenderStateLayout._
    def ofTexture(of: TextureRef => Int) = texture.fold(0)(of)
    def flag(set: Boolean) = if (set) 1 else 0
    encode(
      TextureBase -> ofTexture(_.base),
      Log2Width -> ofTexture(_.log2Width - TextureRef.LeastLog2),
      Log2Height -> ofTexture(_.log2Height - TextureRef.LeastLog2),
      Format -> ofTexture(_.format.code),
      WrapS -> wrapS.code,
      WrapT -> wrapT.code,
      CombineMode -> combine.code,
      DepthTest -> depth.code,
      DepthWrite -> flag(depthWrite),
      Blend -> flag(blend),
      AlphaRef -> alphaRef
    )
  }
}

object RenderState {

  /** States that the store holds. */
  val Count = 16

  /** The state of these words of the wire. If the fields of a texture are 0 and none is needed, there is none.
    *
    * Throws IllegalArgumentException for a code without a meaning.
    */
  def decode(w: Seq[Int]): RenderState = {
    import RenderStateLayout._
    def coded[A](field: Field, all: Seq[A])(code: A => Int): A = all.find(code(_) == field.of(w)).getOrElse(
      throw new IllegalArgumentException(s"render state: ${field.of(w)} is not a code of ${field.name}")
    )
    val combine = coded(CombineMode, Combine.all)(_.code)
    val unnamed = combine == Combine.ColorOnly && Seq(TextureBase, Log2Width, Log2Height, Format).forall(_.of(w) == 0)
    def sideOf(field: Field) = field.of(w) + TextureRef.LeastLog2
    RenderState(
      texture =
        if (unnamed) None
        else Some(TextureRef(
          TextureBase.of(w),
          sideOf(Log2Width),
          sideOf(Log2Height),
          coded(Format, TexelFormat.all)(_.code)
        )),
      wrapS = coded(WrapS, Wrap.all)(_.code),
      wrapT = coded(WrapT, Wrap.all)(_.code),
      combine = combine,
      depth = DepthFunction.decode(DepthTest.of(w)),
      depthWrite = DepthWrite.of(w) == 1,
      blend = Blend.of(w) == 1,
      alphaRef = AlphaRef.of(w)
    )
  }
}
