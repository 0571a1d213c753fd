package frustum.contract

import frustum.contract.raster.{
  Combine,
  Command,
  DepthFunction,
  DrawLayout,
  FixedState,
  PackedTriangle,
  PackedVertex,
  RenderState,
  RenderStateLayout,
  StoredState,
  StoredTriangle,
  StoredVertex,
  TexelFormat,
  TextureRef,
  Wrap
}
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** The tables of bits against words written by hand, and against each other. */
class LayoutTest extends AnyFunSuite {
  private val layouts = Command.all.flatMap(_.parts.map(_.layout)) ++ Seq(StoredVertex, StoredTriangle, StoredState)

  private def random(layout: Layout, r: Random) = layout.fields.map { f =>
    val bits = r.nextInt() & f.ones
    f -> (if (f.signed) bits << (32 - f.width) >> (32 - f.width) else bits)
  }

  test("what is encoded is decoded, and spare bits are 0") {
    val seed = 1
    val r = new Random(seed)
    for (layout <- layouts; _ <- 1 to 200) {
      val values = random(layout, r)
      val words = layout.encode(values: _*)
      for ((f, v) <- values) assert(f.of(words) == v, s"${layout.name}.${f.name}, seed $seed")
      for ((w, n) <- words.zipWithIndex) assert((w & ~layout.mask(n)) == 0, s"${layout.name}, seed $seed")
    }
  }

  private val vertex = PackedVertex(-1, 2, 3, 0x8001, 31, -2, 0x12345, 0x11, 0x22, 0x33, 0x44)

  test("a vertex on the wire and in the store") {
    assert(vertex.words == Seq(0xffff, 2, 3, 0x8001, 0xffff, 0xfffe, 1, 0x2345, 0x1122, 0x3344))
    assert(PackedVertex.decode(vertex.words) == vertex && PackedVertex.WireWords == 10)
    import StoredVertex._
    val words = Seq(0xffff0002, 0x00038001, 0xf9fffffe, 0xfe012345, 0x11223344)
    assert(Seq(X, Y, Z, QMantissa, QExponent, S, T).map(_.of(words)) == Seq(-1, 2, 3, 0x8001, 31, -2, 0x12345))
    assert(Seq(Tag, R, G, B, A).map(_.of(words)) == Seq(127, 0x11, 0x22, 0x33, 0x44))
    assert(StoredVertex.words == 5)
  }

  test("a triangle on the wire and in the store") {
    assert(PackedTriangle(0, 0x3ff, 0x001, 0x155).words == Seq(0x3ff0, 0x0555))
    assert(PackedTriangle.decode(7, Seq(0x3ff0, 0x0555)) == PackedTriangle(7, 0x3ff, 0x001, 0x155))
    import StoredTriangle._
    val words = encode(V0 -> 0x3ff, V1 -> 1, V2 -> 0x155, State -> 9, X0 -> 1, X1 -> 2, Y0 -> 3, Y1 -> 4)
    assert(words == Seq(0x3ff00555, 9 << 28 | 1 << 15 | 2 << 10 | 3 << 5 | 4))
  }

  test("a render state on the wire and in the store") {
    val state = RenderState(
      Some(TextureRef(5, 5, 6, TexelFormat.Rgba4444)),
      Wrap.Clamp,
      Wrap.Mirror,
      Combine.Modulate,
      DepthFunction.LessEq,
      depthWrite = true,
      blend = true,
      alphaRef = 9
    )
    val words = Seq(0xb405, 0x4ee9)
    assert(state.words == words && RenderState.decode(words) == state)
    assert(RenderState.decode(RenderState().words) == RenderState())
    for (f <- RenderStateLayout.fields) assert(StoredState.of(f).of(Seq(0xb4054ee9)) == f.of(words), f.name)
    assert(intercept[IllegalArgumentException](RenderState.decode(Seq(0, 3))).getMessage.contains("wrapS"))
  }

  test("a value that a field cannot hold, and a field that is not there, are refused by name") {
    val beyond = intercept[IllegalArgumentException](vertex.copy(z = 65536).words).getMessage
    assert(beyond.contains("65536 is outside 0..65535 of z"))
    assert(intercept[IllegalArgumentException](FixedState.fields("fog" -> 1)).getMessage.contains("'fog'"))
    assert(
      intercept[IllegalArgumentException](DrawLayout.encode(DrawLayout.Vertices -> 1)).getMessage.contains("triangles")
    )
  }
}
