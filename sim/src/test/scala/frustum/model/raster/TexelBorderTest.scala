package frustum.model.raster

import frustum.contract.raster.{
  Combine,
  DepthFunction,
  FixedState,
  FramePass,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RenderState,
  TexelFormat,
  TextureRef,
  TileRegion,
  VertexRanges,
  Wrap
}
import frustum.judge.FragmentLog
import frustum.raster.texture.LateDivide
import frustum.reference.raster.{ExactCoordinate, ExactCoordinates, Sampler}
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** What is exactly a texel's border belongs to the upper texel: the model against exact fractions of the vertices'
  * numbers, without a margin.
  */
class TexelBorderTest extends AnyFunSuite {
  private val memory = new Array[Int](32768)
  private val wraps = Seq(Wrap.Repeat, Wrap.Mirror, Wrap.Clamp)
  private def pick[A](r: Random, of: Seq[A]): A = of(r.nextInt(of.length))
  private def state(log2: Int, wrap: Wrap) = RenderState(
    Some(TextureRef(0, log2, log2, TexelFormat.Rgb565)),
    wrap,
    wrap,
    Combine.Replace,
    DepthFunction.Always,
    depthWrite = false
  )
  private def vertex(x: Int, y: Int, s: Int, t: Int, q: (Int, Int)) =
    PackedVertex(x, y, 0, q._1, q._2, s, t, 255, 255, 255, 255)
  private val noDepth = (32768, 16)

  /** Coordinates that were judged, and those of them that are exactly a border. */
  private case class Judged(all: Long, borders: Long) {
    def +(o: Judged): Judged = Judged(all + o.all, borders + o.borders)
  }

  /** Draws and judges the coordinates that `looks` picks, by the texture's size. */
  private def judge(config: RasterConfig, state: RenderState, triangles: Seq[IndexedSeq[PackedVertex]], what: String)(
      looks: (ExactCoordinate, Int) => Boolean
  ): Judged = {
    val indexed = triangles.indices.map(i => PackedTriangle(0, 3 * i, 3 * i + 1, 3 * i + 2))
    val pass = FramePass(0, 0, TileRegion.whole(config), IndexedSeq(state), triangles.flatten.toIndexedSeq, indexed)
    val log = new FragmentLog
    new RasterModel(config).draw(pass, memory, new Array[Int](config.width * config.height), Some(log))
    val exact = triangles.map(new ExactCoordinates(_))
    val texture = state.texture.get
    log.fragments.foldLeft(Judged(0, 0)) { (sum, f) =>
      val (s, t) = exact(f.triangle)(f.x, f.y)
      Seq((s, f.texelS, texture.width, state.wrapS), (t, f.texelT, texture.height, state.wrapT)).foldLeft(sum) {
        case (sum, (truth, got, size, wrap)) =>
          if (!looks(truth, size)) sum
          else {
            val due = Sampler.wrap(truth.texel(size), size, wrap)
            assert(got == due, s"$what: pixel (${f.x}, ${f.y}) of ${triangles(f.triangle)}, size $size, $wrap, $truth")
            sum + Judged(1, if (truth.onBorder(size)) 1 else 0)
          }
      }
    }
  }

  test("sprites at every 1/16 pixel, turned, mirrored, magnified and minified: every texel") {
    val seed = 1
    val r = new Random(seed)
    val config = RasterConfig(width = 144, height = 144)
    val judged = for (log2 <- 3 to 7; dx <- 0 until 16; dy <- 0 until 16 if log2 <= 4 || dy == 7 * dx % 16) yield {
      val size = 1 << log2
      // Pixels for a repeat: a texel a pixel, or one and a half, a quarter more, two, a half.
      val side = pick(r, Seq(size, size, size * 3 / 2, size * 5 / 4, 2 * size, size / 2).filter(_ <= 128))
      val from = pick(r, Seq(0, 0, -1, 2, -3)) * 65536
      def ends = { val e = Seq(from, from + 65536); if (r.nextBoolean()) e else e.reverse }
      val (Seq(s0, s1), Seq(t0, t1)) = (ends, ends)
      val (x0, y0, x1, y1) = (dx, dy, dx + 16 * side, dy + 16 * side)
      val q = pick(r, Seq(noDepth, (32768, 11)))
      val swapped = r.nextBoolean() // rows and columns of the texture
      def corner(x: Int, y: Int, s: Int, t: Int) = if (swapped) vertex(x, y, t, s, q) else vertex(x, y, s, t, q)
      val c =
        IndexedSeq(corner(x0, y0, s0, t0), corner(x1, y0, s1, t0), corner(x1, y1, s1, t1), corner(x0, y1, s0, t1))
      val first = r.nextInt(4)
      def triangle(corners: Int*) = corners.map(n => c((n + first) % 4)).toIndexedSeq
      val wrap = pick(r, wraps)
      judge(config, state(log2, wrap), Seq(triangle(0, 1, 2), triangle(0, 2, 3)), s"seed $seed")((_, _) => true)
    }
    val sum = judged.reduce(_ + _)
    info(s"${sum.all} coordinates, ${sum.borders} of them exactly a border")
    assert(sum.borders > 20000)
  }

  /** A triangle with an edge through pixel centres along which s, or t, is 0. */
  private def slanted(r: Random, repeats: Int): IndexedSeq[PackedVertex] = {
    val (dx, dy) = pick(
      r,
      Seq((1, 1), (1, 2), (2, 1), (1, 3), (3, 2), (0, 1), (1, 0), (-1, 2), (-2, 1), (-1, 1), (2, -1), (1, -3))
    )
    val (x, y) = (8 + 16 * r.nextInt(48), 8 + 16 * r.nextInt(48)) // a pixel centre on the edge
    val (back, on) = (r.nextInt(200), 1 + r.nextInt(240))
    def other() = r.between(-repeats * 65536, repeats * 65536)
    val swapped = r.nextBoolean()
    def corner(x: Int, y: Int, s: Int) = {
      val t = other()
      if (swapped) vertex(x, y, t, s, noDepth) else vertex(x, y, s, t, noDepth)
    }
    val far = if (r.nextBoolean()) pick(r, Seq(-1, 1)) * 65536 * (1 + r.nextInt(repeats)) else other()
    val corners = IndexedSeq(
      corner(x - dx * back, y - dy * back, 0),
      corner(x + dx * on, y + dy * on, 0),
      corner(r.between(-600, 1300), r.between(-600, 1300), far)
    )
    val Seq(a, b, c) = { val n = r.nextInt(3); (0 to 2).map(i => corners((i + n) % 3)) }
    if ((b.x - a.x).toLong * (c.y - a.y) > (c.x - a.x).toLong * (b.y - a.y)) IndexedSeq(a, b, c)
    else IndexedSeq(a, c, b)
  }

  /** Barycentric coordinates change by half or more from pixel to pixel: gradients have 16 fraction bits. */
  private def isSliver(v: IndexedSeq[PackedVertex]): Boolean = {
    val (dx1, dy1, dx2, dy2) = (v(1).x - v(0).x, v(1).y - v(0).y, v(2).x - v(0).x, v(2).y - v(0).y)
    Seq(dx1, dy1, dx2, dy2).exists(d => 32L * d.abs >= dx1.toLong * dy2 - dx2.toLong * dy1)
  }

  private def slantedEdges(config: RasterConfig, seed: Int): Unit = {
    val r = new Random(seed)
    val states = for (log2 <- 3 to 7; wrap <- wraps) yield state(log2, wrap)
    val judged = (1 to 3000).map { _ =>
      val triangle =
        Iterator.continually(slanted(r, repeats = 1 << r.nextInt(4))).find(v => !isSliver(v)).get
      judge(config, pick(r, states), Seq(triangle), s"seed $seed")((truth, size) =>
        truth.onBorder(size)
      )
    }.reduce(_ + _)
    info(s"${judged.borders} coordinates")
    assert(judged.borders > 3000)
  }

  private val square = RasterConfig(width = 48, height = 48)
  test("slanted edges through pixel centres, without perspective: every border") {
    slantedEdges(square, seed = 2)
  }
  test("and with the divide for depths near each other") {
    val near = square.copy(
      fixed = FixedState.of((3 to 7).flatMap(l => wraps.map(state(l, _))): _*),
      ranges = VertexRanges(ratio = 3)
    )
    assert(LateDivide.suits(near))
    slantedEdges(near, seed = 5)
  }
}
