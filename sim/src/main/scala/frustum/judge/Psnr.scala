package frustum.judge

/** Peak signal-to-noise ratio of pictures given as 0xRRGGBB, over all three components, peak 255. */
object Psnr {

  /** Sum of squared differences over pixels and components. */
  def squaredError(a: Array[Int], b: Array[Int]): Double = {
    require(a.length == b.length, s"pictures of ${a.length} and ${b.length} pixels")
    a.indices.foldLeft(0.0) { (sum, i) =>
      Seq(16, 8, 0).foldLeft(sum) { (s, shift) =>
        val d = ((a(i) >> shift & 255) - (b(i) >> shift & 255)).toDouble
        s + d * d
      }
    }
  }

  /** Decibels from the squared error of `pixels` pixels; None stands for infinity. */
  def of(squaredError: Double, pixels: Long): Option[Double] =
    if (squaredError == 0) None else Some(10 * scala.math.log10(255.0 * 255 * 3 * pixels / squaredError))

  /** Decibels; None when the pictures are equal. */
  def of(a: Array[Int], b: Array[Int]): Option[Double] = of(squaredError(a, b), a.length)
}
