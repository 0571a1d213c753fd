package frustum.driver.raster

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.Fixtures._
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

class ClipperTest extends AnyFunSuite {
  private val clipper = new Clipper(config)

  test("what lies inside is not touched") {
    val t = IndexedSeq(clipVertex(0, 0, 0, 1), clipVertex(0.5, 0, 0.2, 1), clipVertex(0, 0.5, -1, 1))
    assert(clipper.clip(t) == t)
  }

  test("near and far are cut exactly, attributes in proportion") {
    val t =
      IndexedSeq(clipVertex(0, 0, 0, 2), clipVertex(0.5, 0, -6, 2, s = 4), clipVertex(0, 0.5, 6, 2, t = 8))
    val p = clipper.clip(t)
    assert(p.forall(v => v.clip.z.abs <= v.clip.w), p)
    assert(p.count(v => v.clip.z == -v.clip.w) == 2)
    assert(p.count(v => v.clip.z == v.clip.w) == 2)
    // a third of the way from the first vertex to either of the others
    assert(p.exists(v => v.clip.z == -2 && (v.s - 4 / 3.0).abs < 1e-12 && v.t == 0), p)
    assert(p.exists(v => v.clip.z == 2 && (v.t - 8 / 3.0).abs < 1e-12 && v.s == 0), p)
  }

  test("a vertex behind the eye leaves only points in front of it") {
    val p =
      clipper.clip(IndexedSeq(clipVertex(0, 0, -1.5, -1), clipVertex(0.5, 0, 1, 2), clipVertex(0, 0.5, 1, 2)))
    assert(p.length == 4 && p.forall(_.clip.w > 0), p)
  }

  test("triangles outside one plane are dropped") {
    for ((x, y, z) <- Seq((3, 0, 0), (-3, 0, 0), (0, 3, 0), (0, -3, 0), (0, 0, 3), (0, 0, -3)))
      assert(
        clipper
          .clip(
            IndexedSeq(clipVertex(x, y, z, 1), clipVertex(x + 0.5, y, z, 1), clipVertex(x, y + 0.5, z, 1))
          )
          .isEmpty
      )
  }

  test("sides are cut only at the guard band") {
    // 240 x 320: x = 4 is pixel 600, x = 40 is pixel 4920
    def reaching(x: Double) =
      clipper.clip(IndexedSeq(clipVertex(0, 0, 0, 1), clipVertex(x, 0, 0, 1), clipVertex(0, 0.5, 0, 1)))
    assert(reaching(4).length == 3)
    val p = reaching(40)
    assert(p.length == 4)
    val columns = p.map(v => (v.clip.x / v.clip.w + 1) * config.width / 2)
    assert((columns.max - Clipper.GuardBand).abs < 1e-9)
  }

  test("the guard band holds the widest screen") {
    val wide = new Clipper(RasterConfig(width = 1024, height = 512, tileLog2Width = 5))
    val p = wide.clip(IndexedSeq(clipVertex(-9, -9, 0, 1), clipVertex(9, -9, 0, 1), clipVertex(0, 30, 0, 1)))
    val viewport = new Viewport(RasterConfig(width = 1024, height = 512, tileLog2Width = 5))
    assert(p.map(viewport.pack(_, (0, 0))).forall(_.fault.isEmpty))
  }

  test("random triangles: every result is convex, inside, and packs") {
    val seed = 20260101
    val random = new Random(seed)
    val viewport = new Viewport(config)
    for (n <- 1 to 2000) {
      def value = (random.nextDouble() - 0.5) * scala.math.pow(10, random.nextInt(4))
      val t = IndexedSeq.fill(3) {
        val w = value; clipVertex(value, value, w * (random.nextDouble() * 2.4 - 1.2), w)
      }
      val p = clipper.clip(t)
      for (v <- p if v.clip.w >= 1.0 / 64 && v.clip.w <= 4096) {
        assert(v.clip.z.abs <= v.clip.w * (1 + 1e-12), s"seed $seed, triangle $n")
        assert(viewport.pack(v, (0, 0)).fault.isEmpty, s"seed $seed, triangle $n: $v")
      }
    }
  }

  test("two triangles of an edge get the same new vertices") {
    val seed = 20260102
    val random = new Random(seed)
    for (n <- 1 to 500) {
      def v = clipVertex(
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble() * 8 - 4,
        1 + random.nextDouble()
      )
      val (a, b, c, d) = (v, v, v, v)
      val (left, right) = (clipper.clip(IndexedSeq(a, b, c)), clipper.clip(IndexedSeq(b, a, d)))
      // points of the first polygon on the near plane that lie on the edge a-b must be points of the second
      def onEdge(p: ClipVertex) = p.clip.z.abs == p.clip.w && {
        val f = (p.clip.w - a.clip.w) / (b.clip.w - a.clip.w)
        (a.clip.x + (b.clip.x - a.clip.x) * f - p.clip.x).abs < 1e-9 &&
        (a.clip.y + (b.clip.y - a.clip.y) * f - p.clip.y).abs < 1e-9
      }
      if (left.nonEmpty && right.nonEmpty)
        assert(
          left.filter(onEdge).map(_.clip).toSet == right.filter(onEdge).map(_.clip).toSet,
          s"seed $seed, pair $n"
        )
    }
  }
}
