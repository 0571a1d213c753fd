package frustum.texture

import frustum.raster.RenderStateWord
import frustum.spec.Wrap
import spinal.core._

/** From coordinates to texel addresses; combinational parts of [[TextureUnit]]. */
object TexelAddress {

  /** Index of the texel along one axis, 0..size-1, size = 2^(log2 + 3): the coordinate is wrapped at 1/128
    * resolution, then its lower bits are dropped.
    */
  def index(coordinate: SInt, wrap: Bits, log2: UInt): UInt = {
    val integer = coordinate(coordinate.high downto TextureCoordinate.FractionBits)
    val clamp = wrap === Wrap.Clamp.code
    val flip = wrap === Wrap.Mirror.code && integer.lsb
    val below = clamp && integer.msb
    val above = clamp && !integer.msb && integer.asBits.orR
    val fraction = coordinate(
      TextureCoordinate.FractionBits - 1 downto TextureCoordinate.FractionBits - 7
    ).asBits
    val wrapped = (fraction ^ flip #* 7) & ~(below #* 7) | above #* 7
    Vec((0 to 7).map(n => (wrapped.asUInt >> (4 - n).max(0)).resize(7)))(log2)
  }

  /** Address of texel (`s`, `t`); the lower six bits need no carry because textures start at multiples of 64.
    */
  def apply(s: UInt, t: UInt, state: RenderStateWord): UInt = {
    val row = Vec((0 to 7).map(n => (t << (n.min(4) + 3)).resize(14)))(state.log2Width)
    val offset = row | s.resize(14)
    ((offset(13 downto 6).resize(9) + state.textureBase) ## offset(5 downto 0)).asUInt
  }
}
