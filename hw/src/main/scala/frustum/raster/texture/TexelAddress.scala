package frustum.raster.texture

import frustum.contract.raster.Wrap
import frustum.raster.store.RenderStateWord
import spinal.core._

/** From coordinates to texel addresses; combinational parts of [[TextureUnit]]. */
object TexelAddress {

  /** The decoded state of one axis, in registers, as it is constant while fragments pass. */
  class Axis(wrap: Bits, log2: UInt) extends Area {
    val clamp = RegNext(wrap === Wrap.Clamp.code)
    val mirror = RegNext(wrap === Wrap.Mirror.code)

    /** The size is 2^(size + 3), 8..128. */
    val size = RegNext(Mux(log2.msb, U(4, 3 bits), log2))
    val mask = RegNext(B((0 until 7).map(i => log2 +^ 3 > i))) // bits of the index within the size
  }

  /** Index of the texel along one axis, 0..size-1: the coordinate is wrapped at 1/128 resolution, then its lower bits
    * are dropped. Bits above the size are undefined until the last step.
    */
  def index(coordinate: SInt, axis: Axis): UInt = {
    val integer = coordinate(coordinate.high downto TextureCoordinate.FractionBits)
    val flip = axis.mirror && integer.lsb
    val below = axis.clamp && integer.msb
    val above = axis.clamp && !integer.msb && integer.asBits.orR
    val fraction = coordinate(
      TextureCoordinate.FractionBits - 1 downto TextureCoordinate.FractionBits - 7
    ).asUInt
    val shifted = Vec((0 to 7).map(n => (fraction >> (4 - n).max(0)).resize(7)))(axis.size)
    // Two bits for the four cases: as it is, flipped, all zeros, all ones.
    val fixed = below || above
    val ones = flip || above
    Cat((0 until 7).map(i => axis.mask(i) && Mux(fixed, ones, shifted(i) ^ ones))).asUInt
  }

  /** Address of texel (`s`, `t`); the lower six bits need no carry because textures start at multiples of 64.
    */
  def apply(s: UInt, t: UInt, width: Axis, state: RenderStateWord): UInt = {
    val row = Vec((0 to 7).map(n => (t << (n.min(4) + 3)).resize(14)))(width.size)
    val offset = row | s.resize(14)
    ((offset(13 downto 6).resize(9) + state.textureBase) ## offset(5 downto 0)).asUInt
  }
}
