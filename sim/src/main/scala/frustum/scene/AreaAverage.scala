package frustum.scene

/** Resamples a picture by area average (a box filter): each new texel is the mean of the part of the picture that
  * it covers, texels at the border by the part of them that is covered. No texel takes from beyond an edge, so a
  * picture that repeats, or is mirrored, still does.
  *
  * Channels are averaged as the file has them, as OpenGL does where it is not told otherwise; colours count by
  * their opacity, so that what lies invisible under transparent texels does not show. Sums are exact; the mean is
  * rounded to nearest.
  */
object AreaAverage {

  /** @param row  0xAARRGGBB of a row, asked for once each, from the top
    * @return 0xAARRGGBB, row by row from the top
    */
  def apply(width: Int, height: Int, row: Int => Array[Int], newWidth: Int, newHeight: Int): Array[Int] = {
    val sums = Array.ofDim[Long](newWidth * newHeight, 4)
    val across = overlaps(width, newWidth)
    val down = overlaps(height, newHeight)
    for (y <- 0 until height) {
      val line = averageAlong(row(y), across, newWidth)
      for ((newY, weight) <- down(y); x <- 0 until newWidth; channel <- 0 to 3)
        sums(newY * newWidth + x)(channel) += weight * line(x)(channel)
    }
    sums.map(color(_, width.toLong * height))
  }

  /** For each texel of a side, the new ones it overlaps and by how many `count`-ths of its length. */
  private def overlaps(size: Int, count: Int): IndexedSeq[Seq[(Int, Long)]] = IndexedSeq.tabulate(size) { i =>
    val (from, to) = (i.toLong * count, (i + 1L) * count)
    (from / size to (to - 1) / size).map(j => j.toInt -> (to.min((j + 1) * size) - from.max(j * size)))
  }

  /** Alpha, and red, green and blue times alpha, summed along a row. */
  private def averageAlong(row: Array[Int], across: IndexedSeq[Seq[(Int, Long)]], newWidth: Int): Array[Array[Long]] = {
    val sums = Array.ofDim[Long](newWidth, 4)
    for (x <- row.indices; (newX, weight) <- across(x)) {
      val (argb, sum) = (row(x), sums(newX))
      val alpha = weight * (argb >>> 24)
      sum(0) += alpha
      for (channel <- 1 to 3) sum(channel) += alpha * (argb >> 24 - 8 * channel & 255)
    }
    sums
  }

  private def color(sum: Array[Long], area: Long): Int = {
    def mean(value: Long, of: Long) = if (of == 0) 0 else ((2 * value + of) / (2 * of)).toInt
    mean(sum(0), area) << 24 | mean(sum(1), sum(0)) << 16 | mean(sum(2), sum(0)) << 8 | mean(sum(3), sum(0))
  }
}
