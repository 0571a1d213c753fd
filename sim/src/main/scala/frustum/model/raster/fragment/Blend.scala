package frustum.model.raster.fragment

/** Bit-exact blending by source alpha. */
object Blend {

  /** @param a five bits */
  def channel(source: Int, target: Int, a: Int): Int = {
    val w = a + (a >> 4)
    (source * w + target * (32 - w) + 16) >> 5
  }

  /** RGB565 on RGB565. */
  def apply(source: Int, target: Int, a: Int): Int =
    channel(source >> 11, target >> 11, a) << 11 |
      channel((source >> 5) & 63, (target >> 5) & 63, a) << 5 |
      channel(source & 31, target & 31, a)
}
