package frustum.scene

import frustum.contract.InputError
import frustum.contract.raster.Combine
import frustum.driver.scene.{Material, Scene}
import org.joml.Vector3d
import org.scalatest.funsuite.AnyFunSuite
import java.awt.image.BufferedImage
import java.nio.charset.StandardCharsets
import java.nio.file.{Files, Path}
import javax.imageio.ImageIO

class ObjSceneTest extends AnyFunSuite {

  /** Runs `body` in a directory with these text files and PNGs of 8 x 8 (ok), 8 x 12 and 256 x 256 texels. */
  private def withFiles[T](files: (String, String)*)(body: Path => T): T = {
    val directory = Files.createTempDirectory("frustum")
    try {
      for ((name, text) <- files) Files.write(directory.resolve(name), text.getBytes(StandardCharsets.UTF_8))
      for (
        (name, w, h, argb) <- Seq(
          ("ok.png", 8, 8, 0xff336699),
          ("odd.png", 8, 12, -1),
          ("big.png", 256, 256, -1),
          ("holes.png", 16, 8, 0),
          ("haze.png", 8, 8, 0x80ffffff)
        )
      ) {
        val picture = new BufferedImage(w, h, BufferedImage.TYPE_INT_ARGB)
        for (y <- 0 until h; x <- 0 until w) picture.setRGB(x, y, argb)
        ImageIO.write(picture, "png", directory.resolve(name).toFile)
      }
      val whole = Files.readAllBytes(directory.resolve("ok.png"))
      Files.write(directory.resolve("cut.png"), whole.take(whole.length / 2))
      body(directory)
    } finally {
      Files.list(directory).forEach(f => Files.delete(f))
      Files.delete(directory)
    }
  }

  private def read(obj: String, mtl: String = "", texture: Option[String] = None): Scene =
    withFiles("a.obj" -> obj, "a.mtl" -> mtl)(d => ObjScene.read(d.resolve("a.obj"), texture.map(d.resolve)))

  private val square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"

  test("a polygon becomes a fan with a flat normal, white") {
    val s = read(square + "v -1 0.5 0\nf 1 2 3 4 5")
    assert(s.triangles.length == 3 && s.materials == Seq(Material.White))
    assert(s.triangles.flatMap(_.vertices).forall(_.normal == new Vector3d(0, 0, 1)))
    assert(
      s.triangles.map(t => (t.v1.position.x, t.v2.position.x)) == Seq((1.0, 1.0), (1.0, 0.0), (0.0, -1.0))
    )
  }

  test("polygons with corners inwards are cut along diagonals within them") {
    // an L, an arrow head, and the L seen from behind, each from every corner on
    val l = IndexedSeq((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
    val arrow = IndexedSeq((0, 0), (4, 3), (0, 1), (-4, 3))
    for ((shape, area) <- Seq(l -> 3.0, arrow -> 4.0, l.reverse -> 3.0); first <- shape.indices) {
      val corners = shape.drop(first) ++ shape.take(first)
      val triangles = read(
        corners.map { case (x, y) => s"v $x $y 5\n" }.mkString + "f 1 2 3 4 5 6".take(1 + 2 * shape.length)
      ).triangles
      val normals = triangles.map { t =>
        new Vector3d(t.v1.position).sub(t.v0.position).cross(new Vector3d(t.v2.position).sub(t.v0.position))
      }
      assert(triangles.length == shape.length - 2)
      assert(normals.map(_.z.sign).distinct.length == 1, s"$corners: a triangle turns the other way")
      assert((normals.map(_.z).sum / 2).abs == area, s"$corners")
    }
  }

  test("a polygon that crosses itself or has no area gives as many triangles as any") {
    assert(read("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4").triangles.length == 2)
    assert(read("v 0 0 0\nv 1 1 0\nv 2 2 0\nv 3 3 0\nf 1 2 3 4 1").triangles.length == 3)
  }

  test("a byte order mark is no statement") {
    assert(read("\ufeff" + square + "f 1 2 3").triangles.length == 1)
  }

  test("relative indices, normals, coordinates, comments, continued lines, foreign statements") {
    val s = read(square + "vn 0 3 0 # up\no thing\ng a b\ns off\nf -4/-4/-1 \\\n  -3/-3/1 3/3/1\r\n\n# end")
    val v = s.triangles.head.vertices
    assert(v.map(_.normal) == Seq.fill(3)(new Vector3d(0, 1, 0)))
    assert(v.map(x => (x.s, x.t)) == Seq((0.0, 0.0), (1.0, 0.0), (1.0, 1.0)))
  }

  test("vertex colours") {
    val s = read("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3")
    assert(s.triangles.head.v0.color == ((1.0, 0.5, 0.0, 1.0)))
  }

  test("materials: colour, opacity, pictures") {
    val mtl =
      """newmtl red
        |Ns 10
        |Kd 1 0 0
        |newmtl glass
        |Kd 0 0 1
        |Tr 0.75
        |newmtl wood
        |Kd 0.8 0.8 0.8
        |map_Kd ok.png
        |newmtl fence
        |map_Kd holes.png
        |newmtl haze
        |map_Kd haze.png
        |newmtl pane
        |d 0.5
        |map_Kd ok.png""".stripMargin
    val names = Seq("red", "glass", "wood", "fence", "haze", "pane")
    val s = read(square + "mtllib a.mtl\n" + names.map(n => s"usemtl $n\nf 1/1 2/2 3/3\n").mkString, mtl)
    val m = s.triangles.map(t => s.materials(t.material))
    assert(m.map(_.name) == names)
    assert(m.map(_.color) == Seq((1, 0, 0), (0, 0, 1), (1, 1, 1), (1, 1, 1), (1, 1, 1), (1, 1, 1)))
    assert(m.map(_.alpha) == Seq(1, 0.25, 1, 1, 1, 0.5))
    assert(m.map(_.blend) == Seq(false, true, false, false, true, true))
    assert(m.map(_.alphaTest.isDefined) == Seq(false, false, false, true, false, false))
    assert(
      m.map(_.combine) == Seq(
        Combine.ColorOnly,
        Combine.ColorOnly,
        Combine.Replace,
        Combine.Replace,
        Combine.Replace,
        Combine.Modulate
      )
    )
    assert(m(2).texture.get.argb.toSet == Set(0xff336699) && !m(2).texture.get.hasAlpha)
    assert((m(3).texture.get.width, m(3).texture.get.height, m(3).texture.get.hasAlpha) == ((16, 8, true)))
  }

  test("a face without texture coordinates shows its colour") {
    val s = read(square + "mtllib a.mtl\nusemtl wood\nf 1 2 3\nf 1/1 2/2 3/3", "newmtl wood\nmap_Kd ok.png")
    assert(s.triangles.map(t => s.materials(t.material).texture.isDefined) == Seq(false, true))
  }

  test("a picture given apart goes onto every face") {
    val s = read(square + "f 1/1 2/2 3/3", texture = Some("ok.png"))
    assert(s.materials.map(_.texture.get.width) == Seq(8))
    assert(
      intercept[InputError](read(square + "f 1 2 3", texture = Some("ok.png"))).message
        .contains("no face has texture")
    )
  }

  test("framing: 2.5 radii away, near 0.05 r, far 10 r") {
    val c = read("v 10 0 0\nv 14 0 0\nv 10 2 4\nf 1 2 3").camera
    assert(c.at == new Vector3d(12, 1, 2))
    val offset = new Vector3d(c.eye).sub(c.at).div(2.5 * 3)
    assert(offset.distance(new Vector3d(0.45, 0.35, 0.82)) < 1e-12)
    assert((c.near - 0.15).abs < 1e-12 && (c.far - 30).abs < 1e-12 && c.fovDegrees == 45)
  }

  private val malformed = Seq(
    ("v 0 0\n", "a.obj:1: 'v' with 2 values; write 'v x y z'"),
    ("v 0 0 x\n", "a.obj:1: 'x' is not a number"),
    ("v 0 NaN 0\n", "a.obj:1: 'NaN' is not finite"),
    ("\n\nv 0 Infinity 0\n", "a.obj:3: 'Infinity' is not finite"),
    ("v 1e99 0 0\n", "a.obj:1: a vertex beyond 1e30"),
    ("vt\n", "a.obj:1: 'vt' with 0 values; write 'vt u v'"),
    ("vn 0 1\n", "a.obj:1: 'vn' with 2 values"),
    (square + "f 1 2\n", "a.obj:9: face with 2 vertices; write at least 3"),
    (square + "f 1 2 9\n", "a.obj:9: face names vertex 9 of 4"),
    (square + "# x\nf 1 2 -5\n", "a.obj:10: face names vertex -5 of 4"),
    (square + "f 0 1 2\n", "a.obj:9: face names vertex 0; numbers start at 1"),
    (square + "f 1/5 2/1 3/1\n", "a.obj:9: face names texture coordinate 5 of 4"),
    (square + "f 1//1 2//1 3//1\n", "a.obj:9: face names normal 1 of 0"),
    (square + "f 1/1/1/1 2 3\n", "a.obj:9: '1/1/1/1' in a face; write v, v/vt"),
    (square + "f 1 2 x\n", "a.obj:9: 'x' in a face is not made of whole numbers"),
    (square + "f 1 2 3.5\n", "a.obj:9: '3.5' in a face is not made of whole numbers"),
    (square + "f \\\n1 2 \\\n77\n", "a.obj:9: face names vertex 77 of 4"),
    ("curv 0 1 1 2\n", "a.obj:1: statement 'curv' is not supported"),
    ("l 1 2\n", "a.obj:1: statement 'l' is not supported"),
    ("v 0 0 0\n", "a.obj: there are no faces"),
    ("", "a.obj: there are no faces"),
    ("\u0000\u0001", "a.obj: is not a text file"),
    ("mtllib\n", "a.obj:1: 'mtllib' without a file"),
    ("mtllib b.mtl\n", "b.mtl: there is no such file"),
    ("mtllib a.mtl\nusemtl blue\n", "a.obj:2: material 'blue' is in no mtllib above; there are: red")
  )
  for (((text, message), i) <- malformed.zipWithIndex)
    test(s"refused OBJ $i: $message") {
      val error = intercept[InputError](read(text, "newmtl red\nKd 1 0 0"))
      assert(error.message.contains(message))
    }

  private val malformedMaterials = Seq(
    ("Kd 1 1 1", "a.mtl:1: 'Kd' before any 'newmtl'"),
    ("newmtl", "a.mtl:1: a material without a name"),
    ("newmtl a\nKd 1 0 0 0", "a.mtl:2: 'Kd' with 4 values"),
    ("newmtl a\nKd 1 0 2", "a.mtl:2: 'Kd 1 0 2' is outside 0..1"),
    ("newmtl a\nKd spectral f.rfl", "a.mtl:2: 'Kd spectral' is not supported"),
    ("newmtl a\nd 1.5", "a.mtl:2: 'd 1.5' is outside 0..1"),
    ("newmtl a\nd", "a.mtl:2: 'd' with 0 values"),
    ("newmtl a\nTr NaN", "a.mtl:2: 'NaN' is not finite"),
    ("newmtl a\nmap_Kd", "a.mtl:2: 'map_Kd' without a file"),
    ("newmtl a\nmap_Kd -s 2 2 2 ok.png", "a.mtl:2: map_Kd option '-s' is not supported"),
    ("newmtl a\nmap_Kd none.png", "none.png: there is no such picture"),
    (
      "newmtl a\n\nmap_Kd odd.png",
      "odd.png: the texture is 8 x 12 texels; each side must be 8, 16, 32, 64, 128"
    ),
    ("newmtl a\nmap_Kd big.png", "big.png: the texture is 256 x 256 texels"),
    ("newmtl a\nmap_Kd a.obj", "a.obj: is not a picture in a known format; save it as PNG"),
    ("newmtl a\nmap_Kd cut.png", "cut.png: the picture is damaged")
  )
  for (((text, message), i) <- malformedMaterials.zipWithIndex)
    test(s"refused MTL $i: $message") {
      val error = intercept[InputError](read(square + "mtllib a.mtl\nusemtl a\nf 1/1 2/2 3/3", text))
      assert(error.message.contains(message) && error.message.contains("a.mtl:"))
    }

  test("refused: a missing OBJ, a directory, a wrong picture given apart") {
    withFiles("a.obj" -> (square + "f 1/1 2/2 3/3")) { d =>
      def refusal(file: String, picture: Option[String]) =
        intercept[InputError](ObjScene.read(d.resolve(file), picture.map(d.resolve))).message
      assert(refusal("b.obj", None).endsWith("b.obj: there is no such file; check the name"))
      assert(refusal("", None).contains("cannot be read"))
      assert(refusal("a.obj", Some("odd.png")).contains("odd.png: the texture is 8 x 12"))
      assert(refusal("a.obj", Some("no.png")).contains("no.png: there is no such picture"))
    }
  }
}
