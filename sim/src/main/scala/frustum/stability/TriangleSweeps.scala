package frustum.stability

import frustum.contract.InputError
import frustum.contract.raster.{
  FramePass,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RasterDomains,
  RenderState,
  TileRegion
}
import frustum.judge.{CoverageJudge, LoggedFragment}
import frustum.model.raster.{Rasterizer, ScreenFragment, ScreenFragments}
import frustum.model.raster.texture.PerspectiveDivide
import frustum.reference.raster.{Attributes, ExactCoverage, ScreenVertex, TriangleAttributes}
import scala.collection.mutable.ArrayBuffer
import scala.math.{floor, round, scalb}

/** Single triangles through the model of set-up, walker and perspective divide, beside float64. The hardware's door,
  * which refuses vertices out of range, is [[PackedVertex.fault]].
  */
object TriangleSweeps {
  import SweepTriangles._

  private val small = RasterConfig(64, 64)
  private val medium = RasterConfig(128, 128)
  private val large = RasterConfig(512, 480)

  private def pass(config: RasterConfig, triangles: Seq[Seq[PackedVertex]]): FramePass = {
    triangles.flatten.flatMap(_.fault).headOption.foreach(fault => throw InputError(s"vertex: its $fault"))
    val corners = triangles.toIndexedSeq.map { t =>
      val Seq(a, b, c) = t
      val area = (b.x - a.x).toLong * (c.y - a.y) - (b.y - a.y).toLong * (c.x - a.x)
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

  private def greatest(
      config: RasterConfig,
      triangles: Seq[Seq[PackedVertex]]
  )(error: (ScreenFragment, Attributes) => Double): Double = {
    val p = pass(config, triangles)
    val truths = p.triangles.map(t =>
      new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(p.vertices(i))))
    )
    var most = 0.0
    Rasterizer(config).draw(
      p,
      new ScreenFragments(config)(f => most = most.max(error(f, truths(f.triangle)(f.x, f.y))))
    )
    most
  }

  /** Texels of a texture of 128, the larger of the two directions. */
  private def texelError(f: ScreenFragment, truth: Attributes): Double =
    Seq(f.s -> truth.s, f.t -> truth.t).map { case (plane, exact) =>
      val off = PerspectiveDivide(plane, f.q) / 131072.0 - exact
      (off - 1024 * round(off / 1024)).abs * 128
    }.max

  /** Depth units. What is drawn is the plane without its fraction. */
  private def depthError(f: ScreenFragment, truth: Attributes): Double =
    (scalb(f.z.toDouble, -15) - truth.z).abs

  private def logged(config: RasterConfig, p: FramePass): IndexedSeq[LoggedFragment] = {
    val log = ArrayBuffer.empty[LoggedFragment]
    Rasterizer(config).draw(
      p,
      new ScreenFragments(config)(f => log += LoggedFragment(f.triangle, f.x, f.y, 0, 0, 0))
    )
    log.toIndexedSeq
  }

  private def coverageWrong(config: RasterConfig, triangles: Seq[Seq[PackedVertex]]): Double = {
    val p = pass(config, triangles)
    CoverageJudge.judge(p, logged(config, p), config).wrong.toDouble
  }

  /** A rectangle in three triangles: two meet a vertex half-way along the third's long edge, which lies `off` beside
    * it.
    */
  private def junction(off: Int): Double = {
    val Seq(a, b, c, d) = Seq((100, 100), (1900, 500), (1500, 1900), (100, 1500))
    val m = ((a._1 + c._1) / 2 + off, (a._2 + c._2) / 2)
    val p =
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
    Sweep(RasterDomains.WRatio, 1, 1 << 20, 1e9)(ratio => greatest(small, slanted(ratio, 4))(texelError)),
    Sweep(
      RasterDomains.Repeats,
      1.0 / 16,
      4096,
      16,
      Some(PeerDomain(1.0 / 16, 2, "16 where the start is whole, 2 elsewhere"))
    )(repeats => greatest(small, slanted(4, repeats))(texelError)),
    Sweep(RasterDomains.Area, 1, 1 << 20, 65536)(area => greatest(medium, ofArea(floor(area).toInt))(depthError)),
    Sweep(RasterDomains.TriangleSize, 1, 4096, 64)(size => greatest(large, ofSize(size))(depthError)),
    Sweep(
      RasterDomains.SliverWidth,
      1,
      1024,
      0,
      Some(PeerDomain(None, "54 pixels too many beside 26 right ones, slivers of a pixel"))
    )(width => coverageWrong(medium, slivers(width.toInt))),
    Sweep(RasterDomains.TJunction, 0, 32, Double.PositiveInfinity, whole = true)(off => junction(off.toInt)),
    Sweep(RasterDomains.ScreenSide, 4, 1024, 0, whole = true)(side => screen(side.toInt))
  )
}
