package frustum.reference.raster

import frustum.contract.raster.RasterConfig
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

class CoverageTest extends AnyFunSuite {
  private type Point = (Long, Long)
  private val seed = 20240607L

  private def coverage(p: Point*) = new ExactCoverage(p.map(_._1).toIndexedSeq, p.map(_._2).toIndexedSeq, 16)

  private def area(a: Point, b: Point, c: Point) =
    (b._1 - a._1) * (c._2 - a._2) - (b._2 - a._2) * (c._1 - a._1)

  /** The rule again, otherwise: a centre is moved right by less than any edge could notice, and down by less
    * than that; then it lies on no edge, and is covered when it is strictly inside.
    */
  private def coveredByShift(p: Seq[Point], x: Int, y: Int): Boolean = {
    val k = BigInt(1) << 60
    val (px, py) = (BigInt(16 * x + 8) * k + (BigInt(1) << 30), BigInt(16 * y + 8) * k + 1)
    (0 until 3).forall { i =>
      val ((ax, ay), (bx, by)) = (p(i), p((i + 1) % 3))
      BigInt(bx - ax) * (py - k * ay) - BigInt(by - ay) * (px - k * ax) > 0
    }
  }

  private def point(r: Random, size: Int): Point = {
    // Half the points lie on pixel centres or corners, where edges meet centres exactly.
    def unit = if (r.nextBoolean()) r.nextInt(size * 16).toLong else r.nextInt(size * 2) * 8L
    (unit, unit)
  }

  test("the top-left rule agrees with an infinitesimal shift, and works beyond the screen") {
    val r = new Random(seed)
    for (n <- 0 until 2000) {
      val p = Seq.fill(3)(point(r, 12)).map { case (x, y) => (x - 40, y - 40) }
      val c = coverage(p: _*)
      for (y <- -4 to 10; x <- -4 to 10)
        assert(c.contains(x, y) == coveredByShift(p, x, y), s"seed $seed, triangle $n $p, pixel ($x, $y)")
    }
  }

  test("10,000 pairs that share an edge: along it each pixel belongs to exactly one") {
    val r = new Random(seed)
    var done = 0
    while (done < 10000) {
      val sliver = done % 4 == 0
      val (a, b) = (point(r, 14), point(r, 14))
      def near: Point = if (sliver)
        ((a._1 + b._1) / 2 + r.nextInt(9) - 4, (a._2 + b._2) / 2 + r.nextInt(9) - 4)
      else point(r, 14)
      val (c, d) = (near, near)
      if (area(a, b, c) > 0 && area(b, a, d) > 0) {
        val (one, two) = (coverage(a, b, c), coverage(b, a, d))
        for (y <- 0 to 14; x <- 0 to 14) {
          val count = Seq(one, two).count(_.contains(x, y))
          assert(count <= 1, s"seed $seed: pixel ($x, $y) twice by $a $b $c and $d")
          val p: Point = (16L * x + 8, 16L * y + 8)
          val onEdge = area(a, b, p) == 0 && dot(a, b, p) > 0 && dot(b, a, p) > 0
          if (onEdge) assert(count == 1, s"seed $seed: pixel ($x, $y) missed by $a $b $c and $d")
        }
        done += 1
      }
    }
  }

  private def dot(a: Point, b: Point, p: Point) =
    (b._1 - a._1) * (p._1 - a._1) + (b._2 - a._2) * (p._2 - a._2)

  test("a closed mesh covers its rectangle once, whatever its inner vertices are") {
    val r = new Random(seed)
    val config = RasterConfig(width = 32, height = 32)
    for (_ <- 0 until 50) {
      val grid = IndexedSeq.tabulate(9, 9) { (i, j) =>
        def jitter(k: Int) = if (k == 0 || k == 8) 0 else r.nextInt(31) - 15
        (j * 64L + jitter(j), i * 64L + jitter(i))
      }
      val mesh = for (
        i <- 0 until 8; j <- 0 until 8;
        t <- Seq(
          coverage(grid(i)(j), grid(i)(j + 1), grid(i + 1)(j + 1)),
          coverage(grid(i)(j), grid(i + 1)(j + 1), grid(i + 1)(j))
        )
      ) yield t
      assert(mesh.forall(_.doubleArea > 0))
      assert(ExactCoverage.additiveCount(mesh, config).forall(_ == 1), s"seed $seed")
    }
  }

  test("degenerate and counter-clockwise triangles cover nothing") {
    for (
      p <- Seq(
        Seq((0L, 0L), (160L, 160L), (80L, 80L)),
        Seq((8L, 8L), (8L, 8L), (8L, 8L)),
        Seq((0L, 0L), (0L, 320L), (320L, 0L))
      )
    ) {
      val c = coverage(p: _*)
      assert((0 until 20).forall(i => !c.contains(i, i) && !c.contains(0, i)))
    }
  }

  test("coordinates at the ends of their range do not overflow") {
    val c = coverage((-16383L, -16383L), (16383L, -16383L), (16383L, 16383L))
    assert(c.contains(1000, 0) && !c.contains(0, 1000) && c.doubleArea == 32766L * 32766L)
  }

  test("in double precision the rule is the same") {
    val r = new Random(seed)
    for (_ <- 0 until 500) {
      val p = Seq.fill(3)(point(r, 12))
      val exact = if (area(p(0), p(1), p(2)) < 0) coverage(p.reverse: _*) else coverage(p: _*)
      val float = new FloatCoverage(p.map { case (x, y) =>
        ScreenVertex(x / 16.0, y / 16.0, 0, 1, 0, 0, 0, 0, 0, 0)
      }.toIndexedSeq)
      for (y <- 0 to 12; x <- 0 to 12)
        assert(exact.contains(x, y) == float.contains(x, y), s"seed $seed $p ($x, $y)")
    }
  }
}
