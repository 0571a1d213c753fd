package frustum.stability

import frustum.contract.raster.{Domain, PackedVertex}
import scala.math.{pow, round}
import scala.util.Random

/** Triangles that the sweeps drive to the ends of their ranges: the same at every call. */
private[stability] object SweepTriangles {
  private val Seed = 1L

  def vertex(x: Int, y: Int, z: Int, w: Double, s: Double, t: Double): PackedVertex = {
    val (mantissa, exponent) = PackedVertex.reciprocalW(w)
    PackedVertex(
      x,
      y,
      z,
      mantissa,
      exponent,
      round(s * 65536).toInt,
      round(t * 65536).toInt,
      255,
      255,
      255,
      255
    )
  }

  /** Triangles over most of the small screen; texture coordinates from near 0 at the nearest vertex, as the driver
    * makes them.
    */
  def slanted(ratio: Double, repeats: Double): Seq[Seq[PackedVertex]] = {
    val r = new Random(Seed)
    def position() = r.nextInt(64 * 16)
    Seq.fill(40) {
      val near = Domain.MaxW / ratio.max(1) / (1 + r.nextDouble())
      def far = if (r.nextBoolean()) 1.0 else -1.0
      val (s0, t0) = (2 * r.nextDouble() - 1, 2 * r.nextDouble() - 1)
      val middle = near * pow(ratio, r.nextDouble())
      val start = -(repeats / 2).min(1)
      Seq(
        vertex(position(), position(), 0, near, start * s0.abs, start * t0.abs),
        vertex(position(), position(), 0, near * ratio, far * repeats / 2, far * repeats / 2),
        vertex(position(), position(), 0, middle, -far * repeats / 2, far * repeats / 2 * r.nextDouble())
      )
    }
  }

  /** Triangles of exactly this area, in 1/512 square pixel, most of them slivers, lying over a pixel's centre. */
  def ofArea(area: Int): Seq[Seq[PackedVertex]] = {
    val r = new Random(Seed)
    Seq.fill(300) {
      val n = r.between(20 + area / 1500, 700 + area / 700)
      val m = (area + r.between(0, 4000)) / n + 1
      val (bx, by) = (n, 1)
      val (cx, cy) = (n * m - area, m)
      val centre = (16 * r.nextInt(128) + 8, 16 * r.nextInt(128) + 8)
      val turned = r.nextBoolean()
      def corner(x: Int, y: Int) = {
        val (dx, dy) = (x - (bx + cx) / 3, y - (by + cy) / 3)
        val (px, py) = if (turned) (centre._1 - dy, centre._2 + dx) else (centre._1 + dx, centre._2 + dy)
        vertex(px, py, r.nextInt(65536), 1, 0, 0)
      }
      Seq(corner(0, 0), corner(bx, by), corner(cx, cy))
    }
  }

  /** Triangles with legs of so many pixels; the screen is in their right angle as soon as they are large. */
  def ofSize(pixels: Double): Seq[Seq[PackedVertex]] = {
    val r = new Random(Seed)
    val half = round(pixels * 8).toInt
    Seq.fill(3) {
      def corner(x: Int, y: Int) =
        vertex(
          x - r.nextInt(half / 8 + 1) * x.sign,
          y - r.nextInt(half / 8 + 1) * y.sign,
          r.nextInt(65536),
          1,
          0,
          0
        )
      Seq(corner(half, -half), corner(half, half), corner(-half, half))
    }
  }

  def slivers(width: Int): Seq[Seq[PackedVertex]] = {
    val r = new Random(Seed)
    Seq.fill(60) {
      val Seq(x0, y0, x1, y1) = Seq.fill(4)(r.nextInt(128 * 16))
      val length = scala.math.hypot(x1 - x0, y1 - y0).max(1)
      val (nx, ny) = ((y0 - y1) / length * width, (x1 - x0) / length * width)
      Seq((x0, y0), (x1, y1), ((x1 + nx).round.toInt, (y1 + ny).round.toInt)).map { case (x, y) =>
        vertex(x, y, 0, 1, 0, 0)
      }
    }
  }
}
