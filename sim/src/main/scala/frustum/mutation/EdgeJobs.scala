package frustum.mutation

import frustum.contract.raster.{RasterConfig, WalkerKind}
import frustum.model.raster.scan.{EdgeWalker, Span}
import scala.math.{max, min}
import scala.util.Random

/** A triangle for the edge walker: three edges as the set-up engine hands them over. */
final case class EdgeJob(
    stepX: Seq[Int],
    stepY: Seq[Int],
    values: Seq[Int],
    lastColumn: Int,
    firstRow: Int,
    lastRow: Int
) {
  def spans: Seq[Span] = EdgeWalker.spans(0, lastColumn, firstRow, lastRow, values.toArray, stepX(_), stepY(_))

  /** Pixels that an edge cuts off each of the rows, at most the tile's width. */
  private def cuts(edge: Int, width: Int): Seq[Int] = {
    val (x, y) = (stepX(edge), stepY(edge))
    val topLeft = x > 0 || x == 0 && y > 0
    (0 to lastRow - firstRow).map { row =>
      (0 until width).indexWhere { cut =>
        val value = values(edge) + 16L * (y.toLong * row + x.abs.toLong * cut)
        value > 0 || value == 0 && topLeft
      } match { case -1 => width; case cut => cut }
    }
  }

  /** Lateral steps of the edges in each row, the three of them. One that moves outwards begins with a test. */
  private def lateral(width: Int): Seq[Seq[Int]] = (0 to 2).map { k =>
    val all = cuts(k, width)
    val cut = all.map(min(_, width - 1))
    val test = if (stepY(k) > 0) all.indexWhere(_ < width) else -1
    if (stepX(k) == 0) cut.map(_ => 0)
    else cut.zip(0 +: cut).zipWithIndex.map { case ((now, before), row) =>
      (now - before).abs + (if (row == test) 1 else 0)
    }
  }.transpose

  /** Cycles from `start` until the walker is idle, at most, where spans are taken at once. */
  def mostCycles(kind: WalkerKind, width: Int): Int = 8 + lateral(width).map { steps =>
    kind match {
      case WalkerKind.Serial if steps.max == 0 => 3
      case WalkerKind.Serial                   => 4 + steps.sum + steps.max
      case WalkerKind.Parallel                 => 2 + steps.max
    }
  }.sum
}

/** Triangles that the edge walker is tested with, in families that are hard for it in different ways. */
final class EdgeJobs(config: RasterConfig, r: Random) {

  val families: Seq[(String, () => Seq[EdgeJob])] = Seq(
    "triangles in and around the tile" -> (() =>
      jobs(1500) { val d = 1 << r.between(4, 10); Seq.fill(3)(point(-d, 256 + d)) }
    ),
    "large triangles, whose values are as large as they get" -> (() =>
      jobs(300)(Seq.fill(3)(far)) ++ jobs(300)(Seq(far, far, point(0, 256)))
    ),
    "slivers with gaps between their rows" -> (() =>
      jobs(800) {
        val (x, y) = point(-64, 320)
        val (dx, dy) = (r.between(-600, 600), r.between(-600, 600))
        Seq((x, y), (x + dx, y + dy), (x + dx + r.between(-12, 13), y + dy + r.between(-12, 13)))
      }
    ),
    "level and upright edges" -> (() =>
      jobs(800) {
        val (x0, y0) = point(-64, 320)
        val (x1, y1) = point(-64, 320)
        r.shuffle(Seq((x0, y0), (x1, y1), if (r.nextBoolean()) (x0, y1) else (r.between(-64, 320), y1)))
      }
    ),
    "edges through pixel centres" -> (() => jobs(1000)(Seq.fill(3)(centre))),
    "edges that cut off the whole tile" -> (() =>
      jobs(600) {
        val (dx, dy) = (r.between(-400, 400), r.between(-400, 400))
        Seq.fill(3)(point(0, 256)).map { case (x, y) => (x + dx, y + dy) }
      }
    )
  )

  private def point(from: Int, until: Int) = (r.between(from, until), r.between(from, until))
  private def far = point(-16384, 16384)
  private def centre = (16 * r.between(-4, 20) + 8, 16 * r.between(-4, 20) + 8)

  private def jobs(count: Int)(vertices: => Seq[(Int, Int)]): Seq[EdgeJob] =
    Iterator.continually {
      def last(size: Int) = if (r.nextBoolean()) size - 1 else r.nextInt(size)
      val lastRow = last(config.tileHeight)
      job(vertices, last(config.tileWidth), if (r.nextBoolean()) 0 else r.nextInt(lastRow + 1), lastRow)
    }.flatten.take(count).toSeq

  /** A triangle of vertices in 1/16 pixel from the tile's corner; none where it faces away or is degenerate. */
  private def job(vertices: Seq[(Int, Int)], lastColumn: Int, firstRow: Int, lastRow: Int): Option[EdgeJob] = {
    val edges = vertices.zip(vertices.tail :+ vertices.head)
    val stepX = edges.map { case ((_, y0), (_, y1)) => y0 - y1 }
    val stepY = edges.map { case ((x0, _), (x1, _)) => x1 - x0 }
    val values = edges.indices.map { k =>
      val (x, y) = vertices(k)
      stepX(k).toLong * ((if (stepX(k) < 0) 16 * lastColumn else 0) + 8 - x) + stepY(k).toLong * (16 * firstRow + 8 - y)
    }
    assert(values.forall(_.isValidInt), s"an edge of $vertices leaves 32 bits")
    val Seq((x0, y0), (x1, y1), (x2, y2)) = vertices
    Option.when((x1 - x0) * (y2 - y0).toLong > (x2 - x0) * (y1 - y0).toLong)(
      EdgeJob(stepX, stepY, values.map(_.toInt), lastColumn, firstRow, lastRow)
    )
  }
}

object EdgeJobs {

  /** Clocks, counted from the first, of the six steps and of the three values, each of which follows its edge's last
    * step.
    */
  def times(r: Random): (Seq[Int], Seq[Int]) = {
    val delay = r.between(1, 14)
    val stepAt = (0 to 4).scanLeft(0)((at, _) => at + r.between(1, 5))
    val edgeAt = (0 to 2).scanLeft(-1)((at, k) => max(at + 1, stepAt(2 * k + 1) + delay)).tail
    (stepAt, edgeAt)
  }
}
