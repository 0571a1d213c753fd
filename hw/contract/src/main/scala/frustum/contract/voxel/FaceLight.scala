package frustum.contract.voxel

/** Colour of a texel's channel in the light of its face, 0 to 255. The voxel engine keeps it in tables. */
object FaceLight {

  /** Highlight: a channel times this, in 2^-16, plus a grey. */
  val HighlightScale = 120 * 257
  val HighlightGrey = 125

  /** @param channel 0 to 15
    * @param light   of [[VoxelConfig.Light]], of 256
    */
  def lit(channel: Int, light: Int): Int = channel * 17 * light >> 8

  /** Of the selected face. */
  def highlighted(lit: Int): Int = (lit * HighlightScale >> 16) + HighlightGrey
}
