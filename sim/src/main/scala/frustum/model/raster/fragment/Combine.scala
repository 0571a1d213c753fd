package frustum.model.raster.fragment

/** Bit-exact product of a texel's channel and a vertex colour's. */
object Combine {

  /** @param t
    *   5 or 6 bits; all ones for ColorOnly
    * @param c
    *   0..255; 255 for Replace
    */
  def channel(t: Int, c: Int): Int = (t * (c + (c >> 7)) + 128) >> 8
}
