package frustum.raster.setup

import frustum.contract.raster.PackedVertex
import frustum.contract.raster.SetupWords._
import frustum.model.raster.scan.EdgeWalker
import frustum.model.raster.setup.TriangleSetup
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** The set-up's planes against float64, at every covered pixel of 16 x 16 tiles. */
class TriangleSetupAccuracyTest extends AnyFunSuite {
  private val seed = 1

  private def q(v: PackedVertex) = v.qMantissa * scala.math.pow(2, v.qExponent)

  /** Largest error of each plane in units of its last place, over the pixels that the triangle covers. */
  private def errors(v: IndexedSeq[PackedVertex]): Option[IndexedSeq[Double]] = {
    val setup = new TriangleSetup
    if (!setup.setup(v(0), v(1), v(2))) None
    else {
      val largest = v.map(_.qExponent).max
      val qs = v.map(p => p.qMantissa * scala.math.pow(2, 15 - (largest - p.qExponent)))
      def plane(p: Int)(k: Int): Double = p match {
        case PlaneS => v(k).s / 65536.0 * qs(k) / 256
        case PlaneT => v(k).t / 65536.0 * qs(k) / 256
        case PlaneQ => qs(k)
        case PlaneZ => v(k).z * 32768.0
        case PlaneR => v(k).r * 128.0
        case PlaneG => v(k).g * 128.0
        case PlaneB => v(k).b * 128.0
        case PlaneA => v(k).a * 128.0
      }
      val area = (v(1).x - v(0).x).toDouble * (v(2).y - v(0).y) - (v(2).x - v(0).x).toDouble * (v(1).y - v(0).y)
      val worst = Array.fill(Planes)(0.0)
      for {
        tileY <- 0 until 20
        tileX <- 0 until 15
      } {
        val (left, right, top, bottom) = (tileX * 16, tileX * 16 + 15, tileY * 16, tileY * 16 + 15)
        if (
          v.exists(_.x >= 16 * left) && v.exists(_.x < 16 * right + 16) && v.exists(_.y >= 16 * top) && v.exists(
            _.y < 16 * bottom + 16
          )
        ) {
          setup.edges(left, right, top, bottom)
          val spans = EdgeWalker.spans(left, right, top, bottom, setup.edge, setup.stepX, setup.stepY)
          assert(!setup.outside || spans.isEmpty, s"$v passed over in tile ($tileX, $tileY)")
          spans.headOption.foreach { first =>
            setup.rebase(first.first, first.y)
            for (span <- spans; x <- span.first to span.last; p <- 0 until Planes) {
              val (px, py) = (16 * x + 8 - v(0).x, 16 * span.y + 8 - v(0).y)
              val l1 = ((v(2).y - v(0).y).toDouble * px - (v(2).x - v(0).x).toDouble * py) / area
              val l2 = ((v(1).x - v(0).x).toDouble * py - (v(1).y - v(0).y).toDouble * px) / area
              assert(l1 >= 0 && l2 >= 0 && l1 + l2 <= 1 + 1e-12, s"$v covers ($x, ${span.y})")
              val exact = plane(p)(0) * (1 - l1 - l2) + plane(p)(1) * l1 + plane(p)(2) * l2
              val got =
                setup.initial(p) + (x - first.first) * setup.gradientX(p) + (span.y - first.y) * setup.gradientY(p)
              val value = if (p >= PlaneR) got.toShort.toDouble else got.toDouble
              worst(p) = scala.math.max(worst(p), (value - exact).abs)
            }
          }
        }
      }
      Some(worst.toIndexedSeq)
    }
  }

  private def vertex(r: Random, spread: Int): PackedVertex = PackedVertex(
    x = r.between(-200, 240 * 16 + 200),
    y = r.between(-200, 320 * 16 + 200),
    z = r.nextInt(65536),
    qMantissa = r.between(32768, 65536),
    qExponent = 20 - r.nextInt(spread),
    s = r.between(-4 << 16, 4 << 16),
    t = r.between(-4 << 16, 4 << 16),
    r.nextInt(256),
    r.nextInt(256),
    r.nextInt(256),
    r.nextInt(256)
  )

  /** Whether a barycentric coordinate changes by half or more from pixel to pixel: its gradient then has 16 fraction
    * bits instead of 30.
    */
  private def sliver(v: IndexedSeq[PackedVertex]): Boolean = {
    val (dx1, dy1, dx2, dy2) = (v(1).x - v(0).x, v(1).y - v(0).y, v(2).x - v(0).x, v(2).y - v(0).y)
    val area = dx1.toLong * dy2 - dx2.toLong * dy1
    Seq(dx1, dy1, dx2, dy2).exists(d => 32L * d.abs >= area)
  }

  test("planes of random triangles") {
    val r = new Random(seed)
    val found = Iterator.continually {
      val a = vertex(r, 8)
      val size = 1 << r.between(3, 12)
      def near(v: PackedVertex) = v.copy(x = a.x + r.between(-size, size + 1), y = a.y + r.between(-size, size + 1))
      val v = IndexedSeq(a, near(vertex(r, 8)), near(vertex(r, 8)))
      errors(v).map(sliver(v) -> _)
    }.flatten.take(2000).toSeq
    // A sliver's two barycentric coordinates are off by 2^-17 each a step, differences are below 2^31, steps at most
    // 30.
    for ((name, kind, bound, colorBound) <- Seq(("ordinary", false, 128, 64), ("slivers", true, 30 << 15, 64))) {
      val these = found.filter(_._1 == kind).map(_._2)
      val worst = (0 until Planes).map(p => these.map(_(p)).max)
      val mean = (0 until Planes).map(p => these.map(_(p)).sum / these.size)
      info(s"$name: ${these.size}, worst" + worst.map(w => f" $w%.1f").mkString + ", mean" + mean.map(w =>
        f" $w%.1f"
      ).mkString)
      for (p <- 0 until Planes)
        assert(worst(p) < (if (p >= PlaneR) colorBound else bound), s"$name, plane $p, seed $seed")
    }
  }
}
