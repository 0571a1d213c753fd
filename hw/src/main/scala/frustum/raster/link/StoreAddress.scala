package frustum.raster.link

import frustum.contract.raster.{RenderState, StoreLayout}
import spinal.core._
import spinal.lib._

/** Addresses in a bank of the scene store, put together from bits as [[frustum.contract.raster.StoreLayout]] has them.
  */
object StoreAddress {
  def vertex(layout: StoreLayout, index: UInt, word: UInt): UInt =
    of(layout, 0, word @@ index.resize(layout.config.vertexBits))

  def triangle(layout: StoreLayout, index: UInt, word: UInt): UInt =
    of(layout, layout.triangles, index.resize(layout.config.triangleBits) @@ word.resize(log2Up(layout.triangleWords)))

  def state(layout: StoreLayout, index: UInt, word: UInt): UInt =
    of(layout, layout.states, word @@ index.resize(log2Up(RenderState.Count)))

  private def of(layout: StoreLayout, base: Int, offset: UInt): UInt = {
    val place = offset.resize(layout.bankAddressBits)
    if (base == 0) place else U(base, layout.bankAddressBits bits) | place
  }
}
