package frustum.driver.raster

import frustum.contract.raster.{PackedVertex, RenderState, Wrap}
import frustum.driver.raster.Fixtures._
import org.scalatest.funsuite.AnyFunSuite

class RepeatRemovalTest extends AnyFunSuite {
  private def triangle(wrap: Wrap, w: Seq[Double], s: Seq[Double], t: Seq[Double]) = {
    val v = (0 to 2).map(i => clipVertex(0, 0, 0, w(i), s(i), t(i)))
    ClipTriangle(v, RenderState(wrapS = wrap, wrapT = wrap))
  }

  private def offset(wrap: Wrap, w: Seq[Double], s: Seq[Double], t: Seq[Double] = Seq(0, 0, 0)) =
    RepeatRemoval.offset(triangle(wrap, w, s, t))

  test("coordinates near 0 stay") {
    assert(offset(Wrap.Repeat, Seq(1, 2, 3), Seq(0, 1.9, 127)) == ((0, 0)))
  }

  test("the vertex nearest to the eye decides") {
    assert(offset(Wrap.Repeat, Seq(9, 2, 3), Seq(0, 100.2, 90), Seq(0, -7, 0)) == ((100, -8)))
    assert(offset(Wrap.Repeat, Seq(1, 2, 3), Seq(1e5, 1e5 + 1, 1e5)) == ((100000, 0)))
  }

  test("offsets keep the texel: whole repeats, even when mirrored, none when clamped") {
    for (s <- Seq(3.0, 5.5, 6.0, 1001.0)) {
      assert(offset(Wrap.Mirror, Seq(1, 1, 1), Seq(s, s, s))._1 % 2 == 0)
      assert((s - offset(Wrap.Repeat, Seq(1, 1, 1), Seq(s, s, s))._1).abs <= RepeatRemoval.Step / 2)
    }
    assert(offset(Wrap.Clamp, Seq(1, 1, 1), Seq(100, 101, 102)) == ((0, 0)))
  }

  test("far vertices that would leave the format move the offset, by an even number, as little as they need") {
    assert(offset(Wrap.Mirror, Seq(1, 2, 3), Seq(0, 1.9, 200)) == ((74, 0)))
    assert(offset(Wrap.Repeat, Seq(1, 2, 3), Seq(0, -200, 50)) == ((-74, 0)))
    assert(offset(Wrap.Repeat, Seq(1, 2, 3), Seq(1000, 1000, 1253.9)) == ((1126, 0)))
    for (far <- 120 to 253; nearest <- Seq(-1.5, 0, 1.99); side <- Seq(1, -1)) {
      val s = Seq(nearest, nearest / 2, nearest.min(0) + far + nearest.max(0) - 2)
      val o = offset(Wrap.Repeat, Seq(1, 2, 3), s.map(_ * side))._1
      assert(s.forall(v => (v * side - o).abs * 65536 <= PackedVertex.MaxSt), s"$s $o")
    }
  }

  test("what exceeds the domain is refused with the numbers") {
    def fault(wrap: Wrap, s: Seq[Double], t: Seq[Double] = Seq(0, 0, 0)) =
      RepeatRemoval.fault(triangle(wrap, Seq(1, 2, 3), s, t))
    val message = fault(Wrap.Repeat, Seq(0, 1025, 5)).get
    assert(message.contains("s runs from 0.0 to 1025.0 repeats") && message.contains("at most 1024"))
    assert(fault(Wrap.Repeat, Seq(0, 1024, 5)).isEmpty && fault(Wrap.Mirror, Seq(-512, 512, 5)).isEmpty)
    for (s <- Seq(Seq(1000.0, 1001, 1002), Seq(0.0, 1, 128)))
      assert(fault(Wrap.Clamp, s).get.contains("fewer than 128"))
    assert(fault(Wrap.Repeat, Seq(0, 0, 0), Seq(1e300, 1e300, 1e300)).get.startsWith("texture coordinate t"))
  }

  test("a triangle is cut only where it must be") {
    def parts(s: Double) = RepeatRemoval.parts(triangle(Wrap.Repeat, Seq(1, 2, 3), Seq(0, s, 5), Seq(0, 0, 0)))
    assert(parts(253).length == 1)
    assert(parts(256).length == 2 && parts(256).map(_.v.map(_.s)).forall(s => s.max - s.min <= 254))
  }
}
