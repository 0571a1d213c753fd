package frustum.raster

import frustum.contract.raster.{FramePass, PackedTriangle, PackedVertex, RasterConfig, RenderState, TileRegion}
import scala.util.Random

/** Triangles that find faults in set-up, edges and walker. Positions in 1/16 pixel, attributes anything the link lets
  * in.
  */
final class HardTriangles(config: RasterConfig, r: Random) {
  private type Point = (Int, Int)
  private val (width, height) = (16 * config.width, 16 * config.height)

  private def near(p: Point, reach: Int): Point =
    (p._1 + r.between(-reach, reach + 1), p._2 + r.between(-reach, reach + 1))
  private def onScreen: Point = (r.nextInt(width), r.nextInt(height))
  private def anywhere: Point = near((0, 0), PackedVertex.MaxXy)
  private def size: Int = 1 << r.between(4, 12)

  /** By name, so that a failure says what kind it was. */
  val kinds: IndexedSeq[(String, () => Seq[Point])] = IndexedSeq(
    "any size" -> { () =>
      val p = onScreen; val n = size; Seq(p, near(p, n), near(p, n))
    },
    "within a pixel" -> { () =>
      val p = onScreen; Seq.fill(3)(near(p, 12))
    },
    "sliver" -> { () =>
      val (a, b) = (onScreen, near(onScreen, size))
      val k = r.nextDouble()
      Seq(a, b, near(((a._1 + k * (b._1 - a._1)).toInt, (a._2 + k * (b._2 - a._2)).toInt), 4))
    },
    "needle" -> { () =>
      val p = onScreen; Seq(p, near(p, 1), near(p, size))
    },
    "huge" -> { () => Seq(anywhere, anywhere, if (r.nextBoolean()) anywhere else onScreen) },
    "huge needle" -> { () =>
      val p = anywhere; Seq(p, near((-p._1, -p._2), 3), near((-p._1, -p._2), 3))
    },
    "at the screen's border" -> { () =>
      def border(end: Int) = (if (r.nextBoolean()) 0 else end) + r.between(-40, 41)
      val p = if (r.nextBoolean()) (border(width), r.nextInt(height)) else (r.nextInt(width), border(height))
      Seq(p, near(p, 200), near(p, 200))
    },
    "off the screen" -> { () =>
      val p = (if (r.nextBoolean()) -300 else width + 300, r.nextInt(height))
      Seq.fill(3)(near(p, 290))
    },
    "on pixel centres" -> { () =>
      val p = onScreen; val n = size;
      Seq.fill(3)(near(p, n)).map { case (x, y) => (x & ~15 | 8, y & ~15 | 8) }
    },
    "on pixel corners" -> { () =>
      val p = onScreen; val n = size; Seq.fill(3)(near(p, n)).map { case (x, y) => (x & ~15, y & ~15) }
    },
    "level and upright" -> { () =>
      val (p, n) = (onScreen, size)
      val (a, b) = (near(p, n), near(p, n))
      r.shuffle(Seq(a, b, if (r.nextBoolean()) (a._1, b._2) else (r.nextInt(width), b._2)))
    },
    "a sixteenth off the centres" -> { () =>
      val p = onScreen; val n = size
      Seq.fill(3)(near(p, n)).map { case (x, y) => (x & ~15 | 7 + r.nextInt(3), y & ~15 | 7 + r.nextInt(3)) }
    },
    "degenerate" -> { () =>
      val (p, dx, dy) = (onScreen, r.between(-60, 61), r.between(-60, 61))
      r.shuffle(Seq(p, (p._1 + dx, p._2 + dy), if (r.nextBoolean()) p else (p._1 + 3 * dx, p._2 + 3 * dy)))
    }
  )

  private def clip(v: Int) = v.max(-PackedVertex.MaxXy).min(PackedVertex.MaxXy)
  private def channel() = if (r.nextInt(4) == 0) 255 * r.nextInt(2) else r.nextInt(256)
  private def coordinate() = r.between(-PackedVertex.MaxSt, PackedVertex.MaxSt + 1) >> r.nextInt(12)

  /** A vertex there, its attributes drawn by lot. */
  def vertex(p: Point): PackedVertex = PackedVertex(
    clip(p._1),
    clip(p._2),
    if (r.nextInt(4) == 0) 65535 * r.nextInt(2) else r.nextInt(65536),
    r.between(32768, 65536),
    r.between(8, 24),
    coordinate(),
    coordinate(),
    channel(),
    channel(),
    channel(),
    channel()
  )

  /** A pass of `count` triangles, kind after kind, most of them facing the viewer. */
  def pass(count: Int, frame: Int = 0): FramePass = {
    val triangles = IndexedSeq.tabulate(count) { n =>
      val t = kinds(n % kinds.size)._2().toIndexedSeq.map(vertex)
      if (area(t.map(v => (v.x, v.y))) < 0 && r.nextInt(10) > 0) t.reverse else t
    }
    meshPass(triangles, frame)
  }

  /** Splits triangles again and again: at pixel centres, with level and upright edges, leaving slivers behind. */
  def mesh(outline: Seq[Seq[Point]], count: Int): IndexedSeq[Seq[Point]] = {
    val parts = scala.collection.mutable.ArrayBuffer.from(outline)
    while (parts.size < count) {
      val at = r.nextInt(parts.size)
      val Seq(a, b, c) = parts(at)
      val (i, j) = {
        val (i, j) = (r.nextDouble(), r.nextDouble()); if (i + j > 1) (1 - i, 1 - j) else (i, j)
      }
      val inside = (
        (a._1 + i * (b._1 - a._1) + j * (c._1 - a._1)).toInt,
        (a._2 + i * (b._2 - a._2) + j * (c._2 - a._2)).toInt
      )
      val p = r.nextInt(4) match {
        case 0 => (inside._1 & ~15 | 8, inside._2 & ~15 | 8)
        case 1 => (inside._1 & ~15 | 8, a._2) // with a level edge
        case 2 => (a._1, inside._2 & ~15 | 8)
        case _ => inside
      }
      val split = Seq(Seq(a, b, p), Seq(b, c, p), Seq(c, a, p))
      if (split.forall(area(_) >= 0)) {
        parts(at) = split.head; parts ++= split.tail
      } // else rounding moved it outside
    }
    parts.toIndexedSeq
  }

  /** Triangles without common vertices. */
  def meshPass(triangles: IndexedSeq[Seq[PackedVertex]], frame: Int = 0): FramePass = FramePass(
    frame,
    0,
    TileRegion.whole(config),
    IndexedSeq(RenderState(), RenderState(blend = true, alphaRef = 3)),
    triangles.flatten,
    triangles.indices.map(n => PackedTriangle(n % 2, 3 * n, 3 * n + 1, 3 * n + 2))
  )

  private def area(t: Seq[Point]): Long = {
    val Seq(a, b, c) = t
    (b._1 - a._1).toLong * (c._2 - a._2) - (c._1 - a._1).toLong * (b._2 - a._2)
  }
}
