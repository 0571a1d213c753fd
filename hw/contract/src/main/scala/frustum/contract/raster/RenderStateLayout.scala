package frustum.contract.raster

import frustum.contract.{Field, Layout}
import scala.collection.immutable.ListMap

/** The words of a render state on the wire. Link and store move them in pairs, so their number is even: where the
  * fields need an odd number, a spare word follows.
  */
abstract class StateLayout(name: String) extends Layout(name, wordBits = 16) {
  override def words: Int = (super.words + 1) / 2 * 2
}

/** A render state on the wire, see [[RenderState]]. A new field is added here alone, in a further word where there is
  * no room: link, store and hardware read this table.
  */
object RenderStateLayout extends StateLayout("render state") {
  private def codes(all: (Int, String)*) = all.map { case (code, name) => s"$code $name" }.mkString(", ")
  private val wraps = codes(Wrap.all.map(w => w.code -> w.toString.toLowerCase): _*)
  private val formats = codes(TexelFormat.all.map(f => f.code -> f.toString.toUpperCase): _*)
  private val combines = codes(
    Combine.ColorOnly.code -> "vertex colour alone",
    Combine.Replace.code -> "texel alone",
    Combine.Modulate.code -> "texel * vertex colour"
  )

  val TextureBase = unsigned("textureBase", bits(0, 8, 0), "first texel / 64")
  val Log2Width = unsigned("log2Width", bits(0, 11, 9), "log2 of the texture's width, less 3: 8 to 128 texels")
  val Log2Height = unsigned("log2Height", bits(0, 14, 12), "log2 of the texture's height, less 3")
  val Format = unsigned("texelFormat", bit(0, 15), formats)
  val WrapS = unsigned("wrapS", bits(1, 1, 0), wraps)
  val WrapT = unsigned("wrapT", bits(1, 3, 2), "the same")
  val CombineMode = unsigned("combine", bits(1, 5, 4), combines)
  val DepthTest = unsigned(
    "depthFunction",
    bits(1, 8, 6),
    "sum of 1 less, 2 equal, 4 greater: the fragment passes when its depth is so against the stored one"
  )
  val DepthWrite = unsigned("depthWrite", bit(1, 9), "1: a fragment that passes stores its depth")
  val Blend = unsigned("blend", bit(1, 10), "1: source * alpha + destination * (1 - alpha)")
  val AlphaRef =
    unsigned("alphaRef", bits(1, 15, 11), "fragments whose five-bit alpha is lower are dropped; 0 keeps all")
}

/** A render state in the scene store: the words of the wire in pairs. */
class StoredStateLayout(val wire: StateLayout) extends Layout("stored render state", wordBits = 32) {

  /** The stored field of each field on the wire. */
  val of: ListMap[Field, Field] = ListMap(wire.fields.map(f => f -> add(f.paired)): _*)
}

object StoredState extends StoredStateLayout(RenderStateLayout)
