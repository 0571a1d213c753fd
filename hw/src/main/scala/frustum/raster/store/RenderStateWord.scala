package frustum.raster.store

import frustum.contract.Field
import frustum.contract.raster.{FixedState, RenderStateLayout, StoredStateLayout}
import frustum.raster.store.FieldBits._
import spinal.core._
import spinal.lib._

/** A [[frustum.contract.raster.RenderState]] for the fragment stages: the fields of
  * [[frustum.contract.raster.RenderStateLayout]].
  */
case class RenderStateWord() extends Bundle {
  import RenderStateLayout._
  private def number(field: Field) = UInt(field.width bits)

  val textureBase = number(TextureBase)
  val log2Width = number(Log2Width) // minus 3
  val log2Height = number(Log2Height) // minus 3
  val texelFormat = Bool() // RGBA4444, otherwise RGB565
  val wrapS = Bits(WrapS.width bits)
  val wrapT = Bits(WrapT.width bits)
  val combine = Bits(CombineMode.width bits)
  val depthFunction = Bits(DepthTest.width bits) // less, equal, greater
  val depthWrite = Bool()
  val blend = Bool()
  val alphaRef = number(AlphaRef)

  /** The element of the bundle for a field of the table, which has its name. */
  def value(field: Field): BaseType = elements.collectFirst { case (name, of: BaseType) if name == field.name => of }
    .getOrElse(SpinalError(s"RenderStateWord has no ${field.name}"))

  /** Takes the fields that word `n` of the stored state holds. */
  def load(layout: StoredStateLayout, n: Int, word: Bits): Unit =
    for ((field, stored) <- layout.of if stored.slice.word == n) value(field).assignFromBits(stored.in(word))

  /** With constants for the constant bits. */
  def fixed(f: FixedState): RenderStateWord = if (f == FixedState.None) this
  else {
    val state = RenderStateWord()
    for (field <- fields) {
      val bits = value(field).asBits.asBools.zipWithIndex.map { case (bit, i) =>
        if ((f(field).mask >> i & 1) == 0) bit else Bool((f(field).value >> i & 1) == 1)
      }
      state.value(field).assignFromBits(Cat(bits))
    }
    state
  }
}
