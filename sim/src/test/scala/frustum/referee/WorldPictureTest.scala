package frustum.referee

import frustum.contract.raster.{Combine, RasterConfig, Wrap}
import frustum.driver.linear.Vector3
import frustum.driver.raster.DrawOptions
import frustum.driver.scene.{Camera, Material, MeshVertex, Scene, TextureImage, Triangle}
import org.scalatest.funsuite.AnyFunSuite

/** The referee itself, on pictures whose right answer is plain. */
class WorldPictureTest extends AnyFunSuite {
  private val options = DrawOptions(None, cullBack = false, Wrap.Repeat, 0x102030)

  /** 16 x 8 pixels, one unit each, the origin in the middle, seen from +z. */
  private val camera =
    Camera(Vector3(0, 0, 5), Vector3.Zero, Vector3(0, 1, 0), 45, 1, 9, orthoHeight = Some(8))

  private def vertex(x: Double, y: Double, z: Double, s: Double, t: Double, color: (Double, Double, Double, Double)) =
    MeshVertex(Vector3(x, y, z), Vector3(0, 0, 1), s, t, color)

  /** A rectangle that faces the eye, its texture once across it. */
  private def panel(x0: Double, y0: Double, x1: Double, y1: Double, z: Double, material: Int): Seq[Triangle] = {
    def at(right: Boolean, above: Boolean) = vertex(
      if (right) x1 else x0,
      if (above) y1 else y0,
      z,
      if (right) 1 else 0,
      if (above) 1 else 0,
      (1, 1, 1, 1)
    )
    Seq(
      Triangle(at(false, false), at(true, false), at(true, true), material),
      Triangle(at(false, false), at(true, true), at(false, true), material)
    )
  }

  private def draw(triangles: Seq[Triangle], materials: Material*)(o: DrawOptions = options): WorldPicture =
    new WorldPicture(Request(
      Scene("t", triangles.toIndexedSeq, materials.toIndexedSeq, camera, 0),
      o,
      RasterConfig(width = 16, height = 8)
    ).view)

  private val red = Material.White.copy(name = "red", color = (1, 0, 0))
  private val pane = Material("pane", (0, 0, 1), 0.5, None, Combine.ColorOnly, blend = true, None)

  test("a panel covers the pixels whose centres it holds, right way up, and its edges are not judged") {
    val p = draw(panel(-8, 0, -4, 4, 0, 0), red)()
    for (j <- 0 until 8; i <- 0 until 16) {
      val within = i < 4 && j < 4
      assert(p.picture(j * 16 + i) == (if (within) 0xff0000 else 0x102030), s"pixel ($i, $j)")
    }
    // The diagonal from (-8, 0) to (-4, 4) goes through the centres of the pixels on it.
    assert((0 until 4).forall(k => !p.judged((3 - k) * 16 + k)) && p.judged(0) && p.judged(16 + 3))
  }

  test("what is nearer shows, whatever the order, and what is blended comes last") {
    val near = panel(-8, -4, 8, 4, 1, 0)
    for (triangles <- Seq(near ++ panel(-8, -4, 8, 4, 0, 1), panel(-8, -4, 8, 4, 0, 1) ++ near)) {
      val p = draw(triangles, red, Material.White)()
      assert(p.picture.forall(_ == 0xff0000))
    }
    val glazed = draw(panel(-8, -4, 8, 4, 1, 1) ++ panel(-8, -4, 8, 4, 0, 0), red, pane)()
    assert(glazed.picture.forall(_ == 0x800080))
    assert(glazed.seen.opaque(20) >= 2 && glazed.seen.top(20) < 2)
  }

  test("back faces are those that turn clockwise") {
    val back = panel(-8, -4, 8, 4, 0, 0).map(t => t.copy(v1 = t.v2, v2 = t.v1))
    assert(draw(back, red)()(0, 0) == 0xff0000)
    assert(draw(back, red)(options.copy(cullBack = true))(0, 0) == 0x102030)
    assert(draw(panel(-8, -4, 8, 4, 0, 0), red)(options.copy(cullBack = true))(0, 0) == 0xff0000)
  }

  test("the texture's first texel is at the bottom left; texels on their borders are not judged") {
    val image = TextureImage(8, 8, IndexedSeq.tabulate(64)(i => 0xff000000 | i), hasAlpha = false)
    val p = draw(panel(-8, -4, 8, 4, 0, 0), Material.textured("numbers", image, 1))()
    // The picture's last row is the texture's first.
    for (j <- 0 until 8; i <- 0 until 16) assert(p(i, j) == j * 8 + i / 2, s"pixel ($i, $j)")
    assert(p.texelsJudged.forall(identity))
    val shifted = draw(panel(-8.5, -4, 7.5, 4, 0, 0), Material.textured("numbers", image, 1))()
    assert(
      (1 until 14).forall(i => shifted.texelsJudged(3 * 16 + i) == (i % 2 == 0)),
      "every other centre is on a border"
    )
  }

  test("wrap modes beyond both ends") {
    val expected = Seq(
      Wrap.Repeat -> Seq(6, 7, 0, 1, 7, 0),
      Wrap.Mirror -> Seq(1, 0, 0, 1, 7, 7),
      Wrap.Clamp -> Seq(0, 0, 0, 1, 7, 7)
    )
    for ((mode, texels) <- expected)
      assert(Seq(-2L, -1L, 0L, 1L, 7L, 8L).map(Texturing.wrapped(_, 8, mode)) == texels, mode)
    assert(Seq(-9L, 16L, 17L).map(Texturing.wrapped(_, 8, Wrap.Mirror)) == Seq(7, 0, 1))
  }

  test("light: 0.2 from everywhere and 0.8 by the cosine, in the world, from all sides but behind") {
    def lit(x: Double, y: Double, z: Double, turn: Double = 0) =
      draw(
        panel(-8, -4, 8, 4, 0, 0),
        Material.White
      )(options.copy(light = Some(Vector3(x, y, z)), turnDegrees = turn))(8, 4) & 255
    assert(lit(0, 0, 7) == 255 && lit(0, 0, -1) == 51)
    assert(lit(3, 0, 4) == ((0.2 + 0.8 * 0.8) * 255).round)
    // Turned by 60 degrees about +y, counter-clockwise from above, the normal is (sin 60, 0, cos 60).
    assert(lit(0, 0, 1, 60) == ((0.2 + 0.8 * 0.5) * 255).round && lit(
      1,
      0,
      0,
      60
    ) == ((0.2 + 0.8 * 0.8660254) * 255).round)
  }

  private implicit class Pixels(p: WorldPicture) {
    def apply(i: Int, j: Int): Int = p.picture(j * p.view.width + i)
  }
}
