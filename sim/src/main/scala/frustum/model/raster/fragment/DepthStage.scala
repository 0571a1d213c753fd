package frustum.model.raster.fragment

import frustum.contract.raster.RenderState

/** Bit-exact depth test with the depth buffer of one tile.
  *
  * @param words
  *   pixels of the tile
  */
final class DepthStage(words: Int) {
  private val depth = new Array[Int](words)

  /** Everything is as far away as can be. */
  def clear(): Unit = java.util.Arrays.fill(depth, 65535)

  /** Whether a fragment with depth `z` passes at word `at`, which then holds its depth if the state says so. */
  def apply(at: Int, z: Int, state: RenderState): Boolean = {
    val pass = state.depth.passes(z, depth(at))
    if (pass && state.depthWrite) depth(at) = z
    pass
  }
}
