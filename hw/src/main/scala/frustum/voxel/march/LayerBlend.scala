package frustum.voxel.march

import spinal.core._

/** Arithmetic of layers that are gathered front to back, with weights that sum to 255. */
object LayerBlend {

  /** The part that a layer hides of those behind it, of 16: a texel's alpha of 15 hides all, and so does the sky. */
  def opacity(shown: Bool, rgba: Bits): UInt = {
    val alpha = rgba(3 downto 0).asUInt
    Mux(shown, alpha.resize(5) + alpha.msb.asUInt, U(16))
  }

  /** A channel, from the sum of colours times their weights: x / 255 = (x + 128 + (x + 128) / 256) / 256, rounded. */
  def channel(sum: UInt): UInt = {
    val half = sum + 128
    ((half + (half >> 8)) >> 8).resize(8)
  }
}
