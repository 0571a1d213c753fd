package frustum.reference.raster

import frustum.contract.raster.{FramePass, PackedVertex, RasterConfig, TileRegion}

/** Which pixels a triangle covers. */
trait Coverage {

  /** True when the centre of pixel (x, y) is covered. */
  def contains(x: Int, y: Int): Boolean

  /** The smallest rectangle that holds every covered pixel; may be empty. */
  def bounds: PixelRect

  /** Visits the covered pixels inside `rect`, rows from the top, pixels from the left. */
  def foreach(rect: PixelRect)(visit: (Int, Int) => Unit): Unit = {
    val r = rect.intersect(bounds)
    for (y <- r.y0 to r.y1; x <- r.x0 to r.x1) if (contains(x, y)) visit(x, y)
  }
}

/** A rectangle of pixels, both ends inclusive; empty when an end lies before its start. */
final case class PixelRect(x0: Int, y0: Int, x1: Int, y1: Int) {
  def intersect(o: PixelRect): PixelRect =
    PixelRect(x0.max(o.x0), y0.max(o.y0), x1.min(o.x1), y1.min(o.y1))
  def contains(x: Int, y: Int): Boolean = x >= x0 && x <= x1 && y >= y0 && y <= y1
}

object PixelRect {

  /** The pixels of a tile region that lie on the screen. */
  def of(region: TileRegion, c: RasterConfig): PixelRect = PixelRect(
    region.x0 << c.tileLog2Width,
    region.y0 << c.tileLog2Height,
    (((region.x1 + 1) << c.tileLog2Width) - 1).min(c.width - 1),
    (((region.y1 + 1) << c.tileLog2Height) - 1).min(c.height - 1)
  )
  def screen(c: RasterConfig): PixelRect = PixelRect(0, 0, c.width - 1, c.height - 1)
}

/** Exact coverage of a triangle with integer vertices, by edge functions in whole numbers.
  *
  * With E(p) = (bx - ax)(py - ay) - (by - ay)(px - ax) for the edges a -> b, a centre is inside when all
  * three are positive; one that lies on an edge belongs to the triangle when that edge is a left edge (inside
  * is to its right) or a horizontal top edge (Pineda, "A parallel algorithm for polygon rasterization", 1988,
  * with the top-left rule). Triangles that turn counter-clockwise on the screen, and degenerate ones, cover
  * nothing.
  *
  * @param unit vertex units a pixel, even; coordinates below 2^29 in magnitude cannot overflow
  */
final class ExactCoverage(xs: IndexedSeq[Long], ys: IndexedSeq[Long], unit: Int) extends Coverage {
  require(
    unit > 0 && unit % 2 == 0,
    s"ExactCoverage: $unit units a pixel put the pixel centre between two units"
  )

  private def edge(i: Int, px: Long, py: Long): Long = {
    val j = (i + 1) % 3
    (xs(j) - xs(i)) * (py - ys(i)) - (ys(j) - ys(i)) * (px - xs(i))
  }

  /** Twice the signed area, in units squared; positive when clockwise on a screen whose y points down. */
  val doubleArea: Long = edge(0, xs(2), ys(2))

  private val topLeft = Array.tabulate(3) { i =>
    val (dx, dy) = (xs((i + 1) % 3) - xs(i), ys((i + 1) % 3) - ys(i))
    -dy > 0 || (dy == 0 && dx > 0)
  }

  private def inside(i: Int, px: Long, py: Long) = {
    val e = edge(i, px, py); e > 0 || (e == 0 && topLeft(i))
  }

  def contains(x: Int, y: Int): Boolean = {
    val px = x.toLong * unit + unit / 2
    val py = y.toLong * unit + unit / 2
    doubleArea > 0 && inside(0, px, py) && inside(1, px, py) && inside(2, px, py)
  }

  val bounds: PixelRect = {
    def pixel(v: Long) = scala.math.floorDiv(v, unit.toLong).toInt
    if (doubleArea > 0) PixelRect(pixel(xs.min), pixel(ys.min), pixel(xs.max), pixel(ys.max))
    else PixelRect(0, 0, -1, -1)
  }
}

object ExactCoverage {
  def of(v: Seq[PackedVertex]): ExactCoverage =
    new ExactCoverage(v.map(_.x.toLong).toIndexedSeq, v.map(_.y.toLong).toIndexedSeq, 16)

  /** One coverage for each triangle of the pass. */
  def of(pass: FramePass): IndexedSeq[ExactCoverage] =
    pass.triangles.map(t => of(Seq(t.v0, t.v1, t.v2).map(pass.vertices)))

  /** How many triangles cover each pixel of the screen, row by row: 1 everywhere inside a closed outline. */
  def additiveCount(triangles: Iterable[Coverage], config: RasterConfig): Array[Int] = {
    val count = new Array[Int](config.width * config.height)
    triangles.foreach(_.foreach(PixelRect.screen(config))((x, y) => count(y * config.width + x) += 1))
    count
  }
}

/** Coverage of a triangle whose vertices are not snapped: the same rule in double precision, so exact up to
  * the rounding of the edge functions. Either winding is drawn; degenerate triangles cover nothing.
  */
final class FloatCoverage(v: IndexedSeq[ScreenVertex]) extends Coverage {
  private def edge(a: ScreenVertex, b: ScreenVertex, px: Double, py: Double) =
    (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)
  private val area = edge(v(0), v(1), v(2).x, v(2).y)
  private val turning = if (area < 0) v.reverse else v

  private def inside(a: ScreenVertex, b: ScreenVertex, x: Int, y: Int) = {
    val e = edge(a, b, x + 0.5, y + 0.5)
    e > 0 || (e == 0 && (a.y > b.y || (a.y == b.y && b.x > a.x)))
  }

  def contains(x: Int, y: Int): Boolean = area != 0 && inside(turning(0), turning(1), x, y) &&
    inside(turning(1), turning(2), x, y) && inside(turning(2), turning(0), x, y)

  val bounds: PixelRect = PixelRect(
    v.map(_.x).min.floor.toInt,
    v.map(_.y).min.floor.toInt,
    v.map(_.x).max.floor.toInt,
    v.map(_.y).max.floor.toInt
  )
}
