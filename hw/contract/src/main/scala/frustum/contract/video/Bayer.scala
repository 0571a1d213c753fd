package frustum.contract.video

/** Thresholds of ordered dither: Bayer's 4 x 4 matrix, see B. E. Bayer, "An optimum method for two-level rendition of
  * continuous-tone pictures", 1973.
  */
object Bayer {
  val Matrix: Seq[Seq[Int]] = Seq(Seq(0, 8, 2, 10), Seq(12, 4, 14, 6), Seq(3, 11, 1, 9), Seq(15, 7, 13, 5))

  /** The threshold at a pixel, for a channel that loses `lost` bits: spread over 0 until 2^lost. */
  def threshold(x: Int, y: Int, lost: Int): Int = {
    val t = Matrix(y & 3)(x & 3)
    if (lost <= 4) t >> (4 - lost) else (t << (lost - 4)) + (1 << (lost - 5))
  }
}
