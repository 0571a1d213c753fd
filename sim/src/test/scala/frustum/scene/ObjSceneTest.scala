package frustum.scene

import frustum.contract.InputError
import frustum.contract.raster.Combine
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Material, Scene}
import frustum.files.Notices
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
    withFiles("a.obj" -> obj, "a.mtl" -> mtl)(d =>
      ObjScene.read(d.resolve("a.obj"), ObjScene.Options(texture.map(d.resolve)))
    )

  /** As with `--strict`. */
  private def readStrictly(obj: String, mtl: String): Unit = Notices.refuse(read(obj, mtl).notices)

  private val square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"

  test("a polygon becomes a fan with a flat normal, white") {
    val s = read(square + "v -1 0.5 0\nf 1 2 3 4 5")
    assert(s.triangles.length == 3 && s.materials == Seq(Material.White))
    assert(s.triangles.flatMap(_.vertices).forall(_.normal == Vector3(0, 0, 1)))
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
        (t.v1.position - t.v0.position).cross(t.v2.position - t.v0.position)
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
    assert(v.map(_.normal) == Seq.fill(3)(Vector3(0, 1, 0)))
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

  test("a mesh is framed") {
    val s = read("v 10 0 0\nv 14 0 0\nv 10 2 4\nf 1 2 3")
    assert(s.boundingSphere == ((Vector3(12, 1, 2), 3.0)) && s.camera == Framing(s.boundingSphere, 0.75))
  }

  private val malformed = Seq(
    ("v 0 0\n", "a.obj:1: 'v' with 2 values; write 'v x y z'"),
    ("v 0 0 x\n", "a.obj:1: 'x' is not a number"),
    ("v 0 NaN 0\n", "a.obj:1: 'NaN' is not finite"),
    ("\n\nv 0 Infinity 0\n", "a.obj:3: 'Infinity' is not finite"),
    ("v 1e99 0 0\n", "a.obj:1: a vertex beyond 1e30"),
    ("vt\n", "a.obj:1: 'vt' with 0 values; write 'vt u v'"),
    ("vn 0 1\n", "a.obj:1: 'vn' with 2 values"),
    (square + "f\n", "a.obj:9: face without vertices; write at least 3"),
    (square + "f 1 2 99999999999999999999\n", "a.obj:9: face names vertex 99999999999999999999 of 4"),
    (square + "f 1 2 -3000000000\n", "a.obj:9: face names vertex -3000000000 of 4"),
    (square + "f 1 2\n", "there are no faces ('f' lines); give a mesh of polygons; "),
    ("v 1.#QNAN 0 0\n", "a.obj:1: '1.#QNAN' is not finite"),
    ("v 1f 0 0\n", "a.obj:1: '1f' is not a number"),
    (square + "f 1 2 9\n", "a.obj:9: face names vertex 9 of 4"),
    (square + "# x\nf 1 2 -5\n", "a.obj:10: face names vertex -5 of 4"),
    (square + "f 0 1 2\n", "a.obj:9: face names vertex 0; numbers start at 1"),
    (square + "f 1/5 2/1 3/1\n", "a.obj:9: face names texture coordinate 5 of 4"),
    (square + "f 1//1 2//1 3//1\n", "a.obj:9: face names normal 1 of 0"),
    (square + "f 1/1/1/1 2 3\n", "a.obj:9: '1/1/1/1' in a face; write v, v/vt"),
    (square + "f 1 2 x\n", "a.obj:9: 'x' in a face is not made of whole numbers"),
    (square + "f 1 2 3.5\n", "a.obj:9: '3.5' in a face is not made of whole numbers"),
    (square + "f \\\n1 2 \\\n77\n", "a.obj:9: face names vertex 77 of 4"),
    ("v 0 0 0\n", "a.obj: there are no faces"),
    ("", "a.obj: there are no faces"),
    ("\u0000\u0001", "a.obj: is not a text file"),
    ("l 1 2\n", "a.obj:1: lines ('l', or faces of two corners) are skipped")
  )
  for (((text, message), i) <- malformed.zipWithIndex)
    test(s"refused OBJ $i: $message") {
      val error = intercept[InputError](read(text, "newmtl red\nKd 1 0 0"))
      assert(error.message.contains(message))
    }

  private val skipped = Seq(
    ("f 1 2\n", "a.obj:10: lines ('l', or faces of two corners) are skipped"),
    ("curv 0 1 1 2\n", "a.obj:10: curves and surfaces are skipped"),
    ("l 1 2\n", "a.obj:10: lines"),
    ("call x.obj\n", "a.obj:10: statement 'call' is not known and skipped"),
    ("mtllib\n", "a.obj:10: 'mtllib' without a file"),
    ("mtllib b.mtl\n", "a.obj:10: there is no file 'b.mtl'"),
    ("mtllib a.mtl\nusemtl blue\nf 1 2 3\n", "a.obj:11: material 'blue' is in no mtllib (there are: red)"),
    ("v 1 2 3 4 5 6 7 8\n", "a.obj:10: 'v' with 8 values"),
    ("v 1 2 3 255 0 0\n", "a.obj:10: a vertex colour outside 0..1 is clamped"),
    ("v 1 2 3 nan 0 0\n", "a.obj:10: a vertex colour that is not finite is white"),
    ("vt nan 0\n", "a.obj:10: a texture coordinate is not finite"),
    ("v 1 1 0\nv 0 0 0\nv 0 1 0\nv 1 0 0\nf -4 -3 -2 -1\n", "a.obj:14: a polygon crosses itself")
  )
  for (((text, message), i) <- skipped.zipWithIndex)
    test(s"skipped in an OBJ, refused with --strict $i: $message") {
      val mesh = square + "f 1 2 3\n" + text
      assert(read(mesh, "newmtl red").notices.map(_.what).exists(_.contains(message)))
      assert(intercept[InputError](readStrictly(mesh, "newmtl red")).message.contains(message))
    }

  test("what is of one kind is counted, and the first of it named") {
    val s = read(square + "f 1 2 3\nl 1 2\np 1\nl 2 3\nl 1 3\n")
    assert(s.notices.map(n => (n.what.takeWhile(_ != '(').trim.replaceFirst(".*a.obj", ""), n.count)) == Seq(
      (":10: lines", 3),
      (":11: points", 1)
    ))
  }

  test("a mesh without anything to say about it has no notices") {
    assert(read(square + "o a\ng b\ns 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1").notices.isEmpty)
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
    ("newmtl a\nmap_Kd -s 2 2 2", "a.mtl:2: 'map_Kd -s 2 2 2' without a file"),
    ("newmtl a\nmap_Kd none.png", "a.mtl:2: there is no picture 'none.png'"),
    ("newmtl a\n\nmap_Kd odd.png", "a.mtl:3: odd.png of 8 x 12 texels is resampled to 8 x 128"),
    ("newmtl a\nmap_Kd big.png", "a.mtl:2: big.png of 256 x 256 texels is resampled to 128 x 128"),
    ("newmtl a\nmap_Kd a.obj", "a.obj: is not a picture in a known format; save it as PNG"),
    ("newmtl a\nd -halo 0.5", "a.mtl:2: d: '-halo' changes nothing here"),
    ("newmtl a\nmap_d ok.png\nmap_Kd -s 2 2 2 ok.png\nmap_d -s 3 3 3 haze.png", "give both the same options")
  )
  for (((text, message), i) <- malformedMaterials.zipWithIndex)
    test(s"skipped or replaced in an MTL, refused with --strict $i: $message") {
      val mesh = square + "mtllib a.mtl\nusemtl a\nf 1/1 2/2 3/3"
      assert(read(mesh, text).notices.exists(n => n.what.contains(message) && n.what.contains("a.mtl:")))
      val error = intercept[InputError](readStrictly(mesh, text))
      if (!text.startsWith("Kd") && text != "newmtl")
        assert(error.message.contains(message) && error.message.contains("a.mtl:"))
    }

  test("what follows a material without a name is not the one's before") {
    val s = read(square + "mtllib a.mtl\nusemtl a\nf 1 2 3\nusemtl\nf 1 2 3", "newmtl a\nKd 1 0 0\nnewmtl\nKd 0 1 0")
    assert(s.materials.map(_.color) == Seq((1, 0, 0), (0, 1, 0)))
    assert(s.notices.map(_.what).forall(_.contains("a.mtl:3: a material without a name")) && s.notices.length == 1)
  }

  test("a damaged picture is refused, one that no face shows is not looked at") {
    val mesh = square + "mtllib a.mtl\nusemtl a\nf 1/1 2/2 3/3"
    val error = intercept[InputError](read(mesh, "newmtl a\nmap_Kd cut.png"))
    assert(error.message.contains("a.mtl:2: ") && error.message.contains("cut.png: the picture is damaged"))
    assert(read(mesh, "newmtl b\nmap_Kd cut.png\nnewmtl a").notices.isEmpty)
    assert(read(mesh.replaceAll("/.", ""), "newmtl a\nmap_Kd cut.png").notices.isEmpty)
  }

  test("map_d: opacity from a picture's luminance, or its alpha where it has some, or the channel named") {
    def material(mtl: String) = {
      val s = read(square + "mtllib a.mtl\nusemtl a\nf 1/1 2/2 3/3", mtl); assert(s.notices.isEmpty); s.materials.head
    }
    val both = material("newmtl a\nmap_Kd ok.png\nmap_d haze.png")
    assert(both.texture.get.argb.toSet == Set(0x80336699) && both.blend && both.combine == Combine.Replace)
    val alone = material("newmtl a\nKd 1 0 0\nmap_d haze.png")
    assert(alone.texture.get.argb.toSet == Set(0x80ffffff) && alone.color == ((
      1,
      0,
      0
    )) && alone.combine == Combine.Modulate)
    assert(material("newmtl a\nmap_d ok.png").texture.get.argb.map(_ >>> 24).toSet == Set(
      (0x33 * 299 + 0x66 * 587 + 0x99 * 114 + 500) / 1000
    ))
    assert(material("newmtl a\nmap_d -imfchan b ok.png").texture.get.argb.map(_ >>> 24).toSet == Set(0x99))
    val same = material("newmtl a\nmap_Kd ok.png\nmap_d ok.png")
    assert(same.texture.get.argb.toSet == Set(0xff336699) && !same.blend, "dark colours are no holes")
  }

  test("exact sizes are kept to the bit, others resampled as --texture-size says or memory allows") {
    def sizes(textureSize: Option[Int], texels: Int, pictures: String*) =
      withFiles(
        "a.obj" -> (square + "mtllib a.mtl\n" + pictures.indices.map(i => s"usemtl m$i\nf 1/1 2/2 3/3\n").mkString),
        "a.mtl" -> pictures.zipWithIndex.map { case (p, i) => s"newmtl m$i\nmap_Kd $p\n" }.mkString
      ) { d =>
        val s = ObjScene.read(d.resolve("a.obj"), ObjScene.Options(textureSize = textureSize, texels = texels))
        s.materials.map(m => (m.texture.get.width, m.texture.get.height)) -> s.notices.count(
          _.what.contains("resampled")
        )
      }
    assert(sizes(None, 32768, "ok.png", "holes.png") == (Seq((8, 8), (16, 8)), 0))
    assert(sizes(None, 32768, "ok.png", "odd.png", "big.png") == (Seq((8, 8), (8, 128), (128, 128)), 2))
    assert(sizes(Some(32), 32768, "holes.png", "odd.png", "big.png") == (Seq((16, 8), (8, 32), (32, 32)), 2))
    assert(sizes(None, 4096, "ok.png", "big.png") == (Seq((8, 8), (32, 32)), 1))
    assert(
      sizes(None, 128, "holes.png", "ok.png") == (Seq((8, 8), (8, 8)), 1),
      "exact sizes shrink where the memory is too small for them"
    )
  }

  test("refused: a missing OBJ, a directory, a wrong picture given apart") {
    withFiles("a.obj" -> (square + "f 1/1 2/2 3/3")) { d =>
      def refusal(file: String, picture: Option[String]) =
        intercept[InputError](ObjScene.read(d.resolve(file), ObjScene.Options(picture.map(d.resolve)))).message
      assert(refusal("b.obj", None).endsWith("b.obj: there is no such file; check the name"))
      assert(refusal("", None).contains("cannot be read"))
      assert(refusal("a.obj", Some("cut.png")).contains("cut.png: the picture is damaged"))
      assert(refusal("a.obj", Some("a.obj")).contains("a.obj: is not a picture in a known format"))
      assert(refusal("a.obj", Some("no.png")).contains("no.png: there is no such picture"))
    }
  }
}
