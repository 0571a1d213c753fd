package frustum.raster.store

import frustum.contract.raster.FixedState
import spinal.core._
import spinal.lib._

/** The 32 bits of [[frustum.contract.raster.RenderState]], second word in the upper half, as named fields. */
case class RenderStateWord() extends Bundle {
  val textureBase = UInt(9 bits)
  val log2Width = UInt(3 bits) // minus 3
  val log2Height = UInt(3 bits) // minus 3
  val rgba4444 = Bool()
  val wrapS, wrapT = Bits(2 bits)
  val combine = Bits(2 bits)
  val depthFunction = Bits(3 bits) // less, equal, greater
  val depthWrite = Bool()
  val blend = Bool()
  val alphaRef = UInt(5 bits)

  /** With constants for the bits that are. */
  def fixed(f: FixedState): RenderStateWord = if (f == FixedState.None) this
  else {
    val bits = asBits.asBools.zipWithIndex.map { case (bit, i) =>
      if ((f.mask >> i & 1) == 0) bit else Bool((f.value >> i & 1) == 1)
    }
    val word = RenderStateWord()
    word.assignFromBits(Cat(bits))
    word
  }
}
