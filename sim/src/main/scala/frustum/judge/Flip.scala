package frustum.judge

import scala.math.{Pi, cbrt, exp, hypot, pow, sqrt}

/** LDR-FLIP: how different two pictures look when one flips between them.
  *
  * Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for
  * Alternating Images", HPG 2020. Pictures are sRGB, 0xRRGGBB, row by row. All filters of the paper are sums
  * of separable ones.
  *
  * @param pixelsPerDegree of visual angle; 67 is the paper's monitor of 0.7 m and 3840 pixels at 0.7 m
  */
final class Flip(width: Int, height: Int, pixelsPerDegree: Double = Flip.PixelsPerDegree) {
  private type Plane = Array[Double]
  private val pixels = width * height

  /** Mean error, 0 (equal) to 1. */
  def mean(reference: Array[Int], test: Array[Int]): Double = errors(reference, test).sum / pixels

  /** Error of every pixel, 0 to 1. */
  def errors(reference: Array[Int], test: Array[Int]): Array[Double] = {
    require(reference.length == pixels && test.length == pixels, s"pictures are not $width x $height")
    val Seq(a, b) = Seq(reference, test).map(opponent)
    val color = colorDifference(a, b)
    val feature = featureDifference(a(0), b(0))
    Array.tabulate(pixels)(i => pow(color(i), 1 - feature(i)))
  }

  /** Y, Cx, Cz planes. */
  private def opponent(image: Array[Int]): Array[Plane] = {
    val planes = Array.fill(3)(new Array[Double](pixels))
    for (i <- image.indices) {
      val c = Flip.opponent(Flip.linear(image(i)))
      for (k <- 0 until 3) planes(k)(i) = c(k)
    }
    planes
  }

  /** Section 4.1: contrast sensitivity, Hunt-adjusted L*a*b*, HyAB distance, and its compression to 0..1. */
  private def colorDifference(a: Array[Plane], b: Array[Plane]): Plane = {
    val (fa, fb) = (contrastFiltered(a), contrastFiltered(b))
    Array.tabulate(pixels) { i =>
      def perceived(p: Array[Plane]) =
        Flip.huntLab(Flip.rgbOfOpponent(Array(p(0)(i), p(1)(i), p(2)(i))).map(_.max(0).min(1)))
      val e = pow(Flip.hyab(perceived(fa), perceived(fb)), Flip.Qc)
      val knee = 0.4 * Flip.MaxColorError
      if (e < knee) 0.95 / knee * e else 0.95 + (e - knee) / (Flip.MaxColorError - knee) * 0.05
    }
  }

  private def contrastFiltered(p: Array[Plane]): Array[Plane] = {
    val radius = (3 * sqrt(0.04 / (2 * Pi * Pi)) * pixelsPerDegree).ceil.toInt
    // Per channel the weights a and widths b of its Gaussians, the paper's table 1.
    val terms = Seq(Seq((1.0, 0.0047)), Seq((1.0, 0.0053)), Seq((34.1, 0.04), (13.5, 0.025)))
    terms.zip(p).map { case (gaussians, plane) =>
      val kernels = gaussians.map { case (_, b) =>
        samples(radius)(x => exp(-Pi * Pi * x * x / (b * pixelsPerDegree * pixelsPerDegree)))
      }
      val weights = gaussians.map { case (a, b) => a * sqrt(Pi / b) }
      val total = kernels.zip(weights).map { case (k, w) => w * k.sum * k.sum }.sum
      val parts = kernels.zip(weights).map { case (k, w) => convolve(plane, k, k).map(_ * w / total) }
      parts.reduce((x, y) => Array.tabulate(pixels)(i => x(i) + y(i)))
    }.toArray
  }

  /** Section 4.2: edges and points, by first and second derivatives of a Gaussian as wide as the eye sees. */
  private def featureDifference(a: Plane, b: Plane): Plane = {
    val sigma = 0.5 * 0.082 * pixelsPerDegree
    val radius = (3 * sigma).ceil.toInt
    def gauss(x: Double) = exp(-x * x / (2 * sigma * sigma))
    val smooth = { val k = samples(radius)(gauss); k.map(_ / k.sum) }
    // The positive weights of the whole kernel add up to 1, the negative ones to -1.
    def balanced(k: Array[Double]) = {
      val (positive, negative) = (k.filter(_ > 0).sum, -k.filter(_ < 0).sum)
      k.map(v => if (v > 0) v / positive else v / negative)
    }
    val edge = balanced(samples(radius)(x => -x * gauss(x)))
    val point = balanced(samples(radius)(x => (x * x / (sigma * sigma) - 1) * gauss(x)))
    def strength(image: Plane, kernel: Array[Double]) = {
      val y = image.map(v => (v + 16) / 116)
      val (gx, gy) = (convolve(y, kernel, smooth), convolve(y, smooth, kernel))
      Array.tabulate(pixels)(i => hypot(gx(i), gy(i)))
    }
    val Seq(edges, points) = Seq(edge, point).map { kernel =>
      val (x, y) = (strength(a, kernel), strength(b, kernel))
      Array.tabulate(pixels)(i => (x(i) - y(i)).abs)
    }
    Array.tabulate(pixels)(i => sqrt(edges(i).max(points(i)) / sqrt(2)))
  }

  private def samples(radius: Int)(f: Double => Double) =
    Array.tabulate(2 * radius + 1)(i => f((i - radius).toDouble))

  /** Correlation with kernelX along rows and kernelY down columns; border pixels are repeated outwards. */
  private def convolve(image: Plane, kernelX: Array[Double], kernelY: Array[Double]): Plane = {
    def pass(from: Plane, kernel: Array[Double], length: Int, at: (Int, Int) => Int): Plane = {
      val (to, radius) = (new Array[Double](pixels), kernel.length / 2)
      for (line <- 0 until pixels / length; p <- 0 until length) {
        var sum = 0.0
        var k = 0
        while (k < kernel.length) {
          sum += kernel(k) * from(at(line, (p + k - radius).max(0).min(length - 1)))
          k += 1
        }
        to(at(line, p)) = sum
      }
      to
    }
    val rows = pass(image, kernelX, width, (y, x) => y * width + x)
    pass(rows, kernelY, height, (x, y) => y * width + x)
  }
}

object Flip {
  val PixelsPerDegree: Double = 0.7 * (3840 / 0.7) * Pi / 180

  private val Qc = 0.7

  private type Triple = Array[Double]
  private val xyzOfRgb = Array(
    Array(10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0),
    Array(2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0),
    Array(1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0)
  )
  private val white = xyzOfRgb.map(_.sum)
  private val rgbOfXyz = inverse(xyzOfRgb)

  private def times(m: Array[Array[Double]], v: Triple): Triple =
    m.map(r => r(0) * v(0) + r(1) * v(1) + r(2) * v(2))

  private def inverse(m: Array[Array[Double]]): Array[Array[Double]] = {
    def minor(r: Int, c: Int) = {
      val (r1, r2, c1, c2) = ((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3)
      m(r1)(c1) * m(r2)(c2) - m(r1)(c2) * m(r2)(c1)
    }
    val determinant = (0 until 3).map(c => m(0)(c) * minor(0, c)).sum
    Array.tabulate(3, 3)((r, c) => minor(c, r) / determinant)
  }

  /** sRGB to linear, 0..1. */
  private def linear(rgb: Int): Triple = Array(16, 8, 0).map { shift =>
    val c = (rgb >> shift & 255) / 255.0
    if (c <= 0.04045) c / 12.92 else pow((c + 0.055) / 1.055, 2.4)
  }

  private def relative(rgb: Triple): Triple = times(xyzOfRgb, rgb).zip(white).map { case (v, w) => v / w }

  private def opponent(rgb: Triple): Triple = {
    val v = relative(rgb)
    Array(116 * v(1) - 16, 500 * (v(0) - v(1)), 200 * (v(1) - v(2)))
  }

  private def rgbOfOpponent(c: Triple): Triple = {
    val y = (c(0) + 16) / 116
    times(rgbOfXyz, Array((y + c(1) / 500) * white(0), y * white(1), (y - c(2) / 200) * white(2)))
  }

  /** CIE L*a*b* with chroma scaled by lightness (the Hunt effect). */
  private def huntLab(rgb: Triple): Triple = {
    val delta = 6.0 / 29
    val f =
      relative(rgb).map(t => if (t > delta * delta * delta) cbrt(t) else t / (3 * delta * delta) + 4.0 / 29)
    val l = 116 * f(1) - 16
    Array(l, 0.01 * l * 500 * (f(0) - f(1)), 0.01 * l * 200 * (f(1) - f(2)))
  }

  private def hyab(a: Triple, b: Triple): Double = (a(0) - b(0)).abs + hypot(a(1) - b(1), a(2) - b(2))

  /** The difference of green and blue: the largest within sRGB. */
  private val MaxColorError: Double = pow(hyab(huntLab(Array(0, 1, 0)), huntLab(Array(0, 0, 1))), Qc)
}
