package frustum.lab

import frustum.InputError
import frustum.judge.{CoverageJudge, LoggedFragment}
import frustum.model.raster.{FragmentSink, Rasterizer}
import frustum.model.texture.PerspectiveDivide
import frustum.reference.raster.{Attributes, ExactCoverage, ScreenVertex, TriangleAttributes}
import frustum.spec._
import scala.collection.mutable.ArrayBuffer
import scala.math.{floor, pow, round, scalb}
import scala.util.Random

/** Single triangles through the model of set-up, walker and perspective divide, beside float64. The hardware's door, which refuses
  * vertices out of range, is [[PackedVertex.fault]].
  */
object TriangleSweeps {
  private val Seed   = 1L
  private val small  = RasterConfig(64, 64)
  private val medium = RasterConfig(128, 128)

  /** A covered pixel: what is true there, and the planes. */
  private final case class Probe(x: Int, y: Int, truth: Attributes, s: Int, t: Int, q: Int, z: Int)

  private def pass(config: RasterConfig, triangles: Seq[Seq[PackedVertex]]): FramePass = {
    triangles.flatten.flatMap(_.fault).headOption.foreach(fault => throw InputError(s"vertex: its $fault"))
    val corners = triangles.toIndexedSeq.map { t =>
      val Seq(a, b, c) = t
      val area         = (b.x - a.x).toLong * (c.y - a.y) - (b.y - a.y).toLong * (c.x - a.x)
      if (area < 0) Seq(a, c, b) else t
    }
    FramePass(
      0,
      0,
      TileRegion.whole(config),
      IndexedSeq(RenderState()),
      corners.flatten,
      corners.indices.map(n => PackedTriangle(0, 3 * n, 3 * n + 1, 3 * n + 2))
    )
  }

  private def draw(config: RasterConfig, pass: FramePass)(
      each: (Int, Int, Int, Int, Int, Int, Int) => Unit
  ): Unit =
    Rasterizer(config).draw(
      pass,
      new FragmentSink {
        private var (left, top)           = (0, 0)
        def tile(x: Int, y: Int): Unit    = { left = x * config.tileWidth; top = y * config.tileHeight }
        def tileEnd(x: Int, y: Int): Unit = ()
        def fragment(
            n: Int,
            state: RenderState,
            x: Int,
            y: Int,
            s: Int,
            t: Int,
            q: Int,
            z: Int,
            r: Int,
            g: Int,
            b: Int,
            a: Int
        ): Unit = each(n, left + x, top + y, s, t, q, z)
      }
    )

  private def greatest(
      config: RasterConfig,
      triangles: Seq[Seq[PackedVertex]]
  )(error: Probe => Double): Double = {
    val p      = pass(config, triangles)
    val truths = p.triangles.map(t =>
      new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(p.vertices(i))))
    )
    var most = 0.0
    draw(config, p)((n, x, y, s, t, q, z) => most = most.max(error(Probe(x, y, truths(n)(x, y), s, t, q, z))))
    most
  }

  /** Texels of a texture of 128, the larger of the two directions. */
  private def texelError(p: Probe): Double =
    Seq(p.s -> p.truth.s, p.t -> p.truth.t).map { case (plane, truth) =>
      val off = PerspectiveDivide(plane, p.q) / 131072.0 - truth
      (off - 1024 * round(off / 1024)).abs * 128
    }.max

  /** Depth units. What is drawn is the plane without its fraction. */
  private def depthError(p: Probe): Double = (scalb(p.z.toDouble, -15) - p.truth.z).abs

  private def vertex(x: Int, y: Int, z: Int, w: Double, s: Double, t: Double): PackedVertex = {
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

  /** Triangles over most of the small screen; texture coordinates from near 0 at the nearest vertex, as the driver makes them. */
  private def slanted(ratio: Double, repeats: Double): Seq[Seq[PackedVertex]] = {
    val r          = new Random(Seed)
    def position() = r.nextInt(64 * 16)
    Seq.fill(40) {
      val near     = Domain.MaxW / ratio.max(1) / (1 + r.nextDouble())
      def far      = if (r.nextBoolean()) 1.0 else -1.0
      val (s0, t0) = (2 * r.nextDouble() - 1, 2 * r.nextDouble() - 1)
      val middle   = near * pow(ratio, r.nextDouble())
      val start    = -(repeats / 2).min(1)
      Seq(
        vertex(position(), position(), 0, near, start * s0.abs, start * t0.abs),
        vertex(position(), position(), 0, near * ratio, far * repeats / 2, far * repeats / 2),
        vertex(position(), position(), 0, middle, -far * repeats / 2, far * repeats / 2 * r.nextDouble())
      )
    }
  }

  /** Triangles of exactly this area, in 1/512 square pixel, most of them slivers, lying over a pixel's centre. */
  private def ofArea(area: Int): Seq[Seq[PackedVertex]] = {
    val r = new Random(Seed)
    Seq.fill(300) {
      val n                      = r.between(20 + area / 1500, 700 + area / 700)
      val m                      = (area + r.between(0, 4000)) / n + 1
      val (bx, by)               = (n, 1)
      val (cx, cy)               = (n * m - area, m)
      val centre                 = (16 * r.nextInt(128) + 8, 16 * r.nextInt(128) + 8)
      val turned                 = r.nextBoolean()
      def corner(x: Int, y: Int) = {
        val (dx, dy) = (x - (bx + cx) / 3, y - (by + cy) / 3)
        val (px, py) = if (turned) (centre._1 - dy, centre._2 + dx) else (centre._1 + dx, centre._2 + dy)
        vertex(px, py, r.nextInt(65536), 1, 0, 0)
      }
      Seq(corner(0, 0), corner(bx, by), corner(cx, cy))
    }
  }

  private val large = RasterConfig(512, 480)

  /** Triangles with legs of so many pixels; the screen is in their right angle as soon as they are large. */
  private def ofSize(pixels: Double): Seq[Seq[PackedVertex]] = {
    val r    = new Random(Seed)
    val half = round(pixels * 8).toInt
    Seq.fill(3) {
      def corner(x: Int, y: Int) =
        vertex(x - r.nextInt(half / 8 + 1) * x.sign, y - r.nextInt(half / 8 + 1) * y.sign, r.nextInt(65536), 1, 0, 0)
      Seq(corner(half, -half), corner(half, half), corner(-half, half))
    }
  }

  private def logged(config: RasterConfig, p: FramePass): IndexedSeq[LoggedFragment] = {
    val log = ArrayBuffer.empty[LoggedFragment]
    draw(config, p)((n, x, y, _, _, _, _) => log += LoggedFragment(n, x, y, 0, 0, 0))
    log.toIndexedSeq
  }

  private def coverageWrong(config: RasterConfig, triangles: Seq[Seq[PackedVertex]]): Double = {
    val p = pass(config, triangles)
    CoverageJudge.judge(p, logged(config, p), config).wrong.toDouble
  }

  private def slivers(width: Int): Seq[Seq[PackedVertex]] = {
    val r = new Random(Seed)
    Seq.fill(60) {
      val Seq(x0, y0, x1, y1) = Seq.fill(4)(r.nextInt(128 * 16))
      val length              = scala.math.hypot(x1 - x0, y1 - y0).max(1)
      val (nx, ny)            = ((y0 - y1) / length * width, (x1 - x0) / length * width)
      Seq((x0, y0), (x1, y1), ((x1 + nx).round.toInt, (y1 + ny).round.toInt)).map { case (x, y) =>
        vertex(x, y, 0, 1, 0, 0)
      }
    }
  }

  /** A rectangle in three triangles: two meet a vertex half-way along the third's long edge, which lies `off` beside it. */
  private def junction(off: Int): Double = {
    val Seq(a, b, c, d) = Seq((100, 100), (1900, 500), (1500, 1900), (100, 1500))
    val m               = ((a._1 + c._1) / 2 + off, (a._2 + c._2) / 2)
    val p               =
      pass(
        medium,
        Seq(Seq(a, b, c), Seq(a, m, d), Seq(m, c, d)).map(_.map { case (x, y) => vertex(x, y, 0, 1, 0, 0) })
      )
    val whole = ExactCoverage.additiveCount(
      ExactCoverage.of(pass(
        medium,
        Seq(Seq(a, b, c), Seq(a, c, d)).map(_.map { case (x, y) => vertex(x, y, 0, 1, 0, 0) })
      )),
      medium
    )
    val counts = new Array[Int](medium.width * medium.height)
    logged(medium, p).foreach(f => counts(f.y * medium.width + f.x) += 1)
    counts.indices.count(i => counts(i) != whole(i)).toDouble
  }

  private def screen(side: Int): Double = {
    val config = RasterConfig(side, side)
    val corner = 16 * side
    coverageWrong(
      config,
      Seq(Seq((0, 0), (corner, 0), (corner, corner)), Seq((0, 0), (corner, corner), (0, corner)))
        .map(_.map { case (x, y) => vertex(x, y, 0, 1, 0, 0) })
    )
  }

  val all: Seq[Sweep] = Seq(
    Sweep(ValidFor.WRatio, 1, 1 << 20, 1e9)(ratio => greatest(small, slanted(ratio, 4))(texelError)),
    Sweep(
      ValidFor.Repeats,
      1.0 / 16,
      4096,
      16,
      Some(PeerDomain(1.0 / 16, 2, "16 where the start is whole, 2 elsewhere"))
    )(repeats => greatest(small, slanted(4, repeats))(texelError)),
    Sweep(ValidFor.Area, 1, 1 << 20, 65536)(area => greatest(medium, ofArea(floor(area).toInt))(depthError)),
    Sweep(ValidFor.TriangleSize, 1, 4096, 64)(size => greatest(large, ofSize(size))(depthError)),
    Sweep(
      ValidFor.SliverWidth,
      1,
      1024,
      0,
      Some(PeerDomain(None, "54 pixels too many beside 26 right ones, slivers of a pixel"))
    )(width => coverageWrong(medium, slivers(width.toInt))),
    Sweep(ValidFor.TJunction, 0, 32, Double.PositiveInfinity, whole = true)(off => junction(off.toInt)),
    Sweep(ValidFor.ScreenSide, 4, 1024, 0, whole = true)(side => screen(side.toInt))
  )
}
