package frustum.command.render

import frustum.command.common.Words
import frustum.command.MeshPicture
import frustum.scene.MeshFiles
import frustum.scene.MeshFiles._
import org.scalatest.funsuite.AnyFunSuite
import java.nio.charset.Charset
import java.nio.file.{Files, Path}

/** Meshes as tools write them, and what is right about their pictures. A square fills the picture of 64 x 64 pixels. */
class RenderMeshTest extends AnyFunSuite {
  private val White = 0xffffff
  private val Red = 0xff0000
  private val Green = 0x00ff00
  private val Orange = 0xff8200 // 0.5 in six bits
  private val Texels = Seq(MeshFiles.Yellow, MeshFiles.Blue).map(_ & 0xffffff)

  private def draw(folder: Path, arguments: String*): MeshPicture =
    MeshPicture.draw(folder.resolve("m.obj"), MeshPicture.front ++ arguments: _*)

  /** The picture of the textured square with a material. */
  private def withMaterial(mtl: String, arguments: String*)(check: MeshPicture => Unit): Unit =
    withFiles("m.obj" -> texturedSquare, "m.mtl" -> mtl) { folder =>
      quarters(folder.resolve("t.png"))
      quarters(folder.resolve("t t.png"))
      quarters(folder.resolve("wood #3.png"))
      check(draw(folder, arguments: _*))
    }

  private def plain(mesh: String, files: (String, String)*)(check: MeshPicture => Unit): Unit =
    withFiles(("m.obj" -> mesh) +: files: _*)(folder => check(draw(folder)))

  /** Quarters as the file has them: yellow at top left and bottom right. */
  private def isQuarters(p: MeshPicture): Unit =
    assert(Seq(p(16, 16), p(48, 16), p(16, 48), p(48, 48)) == Seq(Texels(0), Texels(1), Texels(1), Texels(0)))

  /** A quad left of the middle and one right of it. */
  private val pair = "v -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\n"

  test("01: two files after mtllib") {
    plain(
      s"mtllib a.mtl b.mtl\n${pair}usemtl red\nf 1 2 3 4\nusemtl green\nf 2 5 6 3\n",
      "a.mtl" -> "newmtl red\nKd 1 0 0\n",
      "b.mtl" -> "newmtl green\nKd 0 1 0\n"
    ) { p => assert(p.notices.isEmpty && p(10, 32) == Red && p(50, 32) == Green) }
  }

  test("01: of two files that have a material the first counts; names may hold blanks and stand in quotes") {
    plain(
      s"mtllib a b.mtl \"c d.mtl\"\n${pair}usemtl red\nf 1 2 3 4\nusemtl green\nf 2 5 6 3\n",
      "a b.mtl" -> "newmtl red\nKd 1 0 0\n",
      "c d.mtl" -> "newmtl red\nKd 0 0 1\nnewmtl green\nKd 0 1 0\n"
    ) { p => assert(p.notices.isEmpty && p(10, 32) == Red && p(50, 32) == Green) }
  }

  test("02: map_Kd -s repeats, -o shifts, -clamp clamps") {
    withMaterial("newmtl m\nmap_Kd -s 2 2 1 t.png\n") { p =>
      assert(p.notices.isEmpty)
      for (x <- Seq(0, 32); y <- Seq(0, 32)) assert(Seq(p(x + 8, y + 8), p(x + 24, y + 8)) == Texels)
    }
    withMaterial("newmtl m\nmap_Kd -o 0.25 0 0 t.png\n") { p =>
      // s runs from 1/4 to 5/4
      assert(p.notices.isEmpty && Seq(8, 24, 40, 56).map(p(_, 8)) == Seq(Texels(0), Texels(1), Texels(1), Texels(0)))
    }
    withMaterial("newmtl m\nmap_Kd -s 2 2 1 -clamp on t.png\n") { p =>
      assert(p.notices.isEmpty && Seq(8, 24, 40, 56).map(p(_, 56)) == Seq(Texels(1), Texels(0), Texels(0), Texels(0)))
    }
    withMaterial("newmtl m\nmap_Kd -clamp off t.png\n")(p => { assert(p.notices.isEmpty); isQuarters(p) })
  }

  test("02: other options are named in a notice; options may follow the name") {
    for (
      (options, names) <- Seq(
        "-bm 1 -imfchan m t.png" -> Seq("'-bm'", "'-imfchan'"),
        "-texres 8 t.png" -> Seq("'-texres'"),
        "-blendu on -mm 0 1 -foo 3 on t.png" -> Seq("'-blendu'", "'-mm'", "'-foo'")
      )
    )
      withMaterial(s"newmtl m\nmap_Kd $options\n") { p =>
        isQuarters(p)
        assert(p.notices.length == 1 && names.forall(p.notices.head.contains), p.notices)
      }
    withFiles("m.obj" -> texturedSquare, "m.mtl" -> "newmtl m\nmap_Kd -s 2 2 1 deep/t.png\n") { folder =>
      Files.createDirectories(folder.resolve("deep"))
      quarters(folder.resolve("deep/t.png"))
      MeshFiles.picture(folder.resolve("t.png"), 8, 8)((_, _) => -1)
      val p = draw(folder)
      assert(
        p.notices.isEmpty && p(8, 8) == Texels(0) && p(24, 8) == Texels(1),
        "options are no part of a folder's name"
      )
    }
    withMaterial("newmtl m\nmap_Kd t.png -s 2 2 1\n")(p =>
      assert(p.notices.isEmpty && p(8, 8) == Texels(0) && p(24, 8) == Texels(1))
    )
  }

  test("03: of d and Tr the first counts, in any order") {
    for (lines <- Seq("d 1\nTr 1", "Tr 1\nd 1", "d 1\nTr 0", "d 0.999999", "D 1"))
      withMaterial(s"newmtl m\nKd 1 0.5 0\n$lines\n")(p => assert(p.notices.isEmpty && p(32, 32) == Orange, lines))
  }

  test("03: a mesh that is wholly transparent is drawn as written, with a notice") {
    for (line <- Seq("d 0", "Tr 1")) withMaterial(s"newmtl m\nKd 1 0.5 0\n$line\n") { p =>
      assert(
        p.covered == 0 && p.notices.length == 1 && p.notices.head.contains(
          "m.mtl:1: the whole mesh is wholly transparent"
        ),
        p.run
      )
      assert(p.report.get("notices")(0)("count").num == 1)
    }
    withMaterial("newmtl m\nd 0\n", "--strict")(p =>
      assert(p.run.code == 2 && p.run.err.length == 1 && p.picture.isEmpty)
    )
    plain(s"mtllib m.mtl\n${pair}usemtl m\nf 1 2 3 4\nusemtl n\nf 2 5 6 3\n", "m.mtl" -> "newmtl m\nTr 1\nnewmtl n\n") {
      p =>
        assert(p(50, 32) == White && p(10, 32) == 0 && p.notices.head.contains("a face of material 'm'"))
    }
  }

  test("04: a comment that ends in a backslash is over with its line, in OBJ and MTL") {
    plain("# saved from C:\\models\\\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n") { p =>
      assert(p.notices.isEmpty && p.covered == 64 * 64)
    }
    plain(square + "v 0 3 0\n# group C:\\roof\\\nf 4 3 5\nf 1 2 3 4 # all of C:\\\nf 1 2 3\n") { p =>
      assert(p.notices.isEmpty && p.report.get("triangles").num == 4)
    }
    plain(square + "g C:\\roof\\\nf 1 2 3 4\n")(p => assert(p.report.get("triangles").num == 2))
    withMaterial("newmtl m # C:\\\n# C:\\mats\\\nKd 1 0 0\nKs 1 1 1 # C:\\\nKd 0 1 0")(p =>
      assert(p(32, 32) == Green && p.notices.isEmpty)
    )
  }

  test("05: # in a material's and in a picture's name") {
    plain(
      s"mtllib m.mtl\n${pair}usemtl Grey #1\nf 1 2 3 4\nusemtl Grey #2\nf 2 5 6 3\n",
      "m.mtl" -> "newmtl Grey #1\nKd 1 0 0\n\nnewmtl Grey #2\nKd 0 1 0\n"
    ) { p => assert(p.notices.isEmpty && p(10, 32) == Red && p(50, 32) == Green) }
    withMaterial("newmtl m\nmap_Kd wood #3.png\n")(p => { assert(p.notices.isEmpty); isQuarters(p) })
    withMaterial("newmtl m # the only one\nmap_Kd t.png # a comment\n")(p => {
      assert(p.notices.isEmpty); isQuarters(p)
    })
  }

  test("06: normals that are not numbers are made from the face") {
    for (nan <- Seq("nan nan nan", "-nan(ind) 0 0", "1.#QNAN 0 1", "-1.#IND -1.#IND -1.#IND", "inf 0 0"))
      plain(square + s"vn $nan\nvn 0 0 1\nf 1/1/1 2/2/2 3/3/2 4/4/2\n") { p =>
        assert(p(2, 61) == White && p.notices.length == 1 && p.notices.head.contains("m.obj:9: a normal is not finite"))
      }
  }

  test("07: lines, points and curves are skipped with a notice that counts them") {
    plain(
      square + "f 1 2 3 4\nl 1 3\nl 1 2 3\nf 1 3\np 1 2\n" +
        "vp 0.5\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n"
    ) { p =>
      assert(p.covered == 64 * 64)
      assert(p.notices.length == 3)
      assert(p.notices(0).contains("m.obj:10: lines") && p.notices(0).endsWith("(3)"))
      assert(p.notices(1).contains("m.obj:13: points") && p.notices(1).endsWith("(1)"))
      assert(p.notices(2).contains("m.obj:14: curves and surfaces") && p.notices(2).endsWith("(6)"))
    }
    plain(square + "f 1 2 3 4\nl 1 3\n")(p => assert(p.report.get("triangles").num == 2))
  }

  private val missing = Seq(
    ("mtllib gone.mtl", "usemtl m", "", White, Seq("no file 'gone.mtl'", "material 'm' is in no mtllib")),
    (
      "mtllib m.mtl",
      "usemtl m",
      "newmtl m\nKd 1 0 0\nmap_Kd gone.png\n",
      Red,
      Seq("m.mtl:3: there is no picture 'gone.png'")
    ),
    (
      "mtllib m.mtl",
      "usemtl other",
      "newmtl m\nKd 1 0 0\n",
      White,
      Seq("material 'other' is in no mtllib (there are: m)")
    ),
    ("", "usemtl other", "", White, Seq("material 'other' is in no mtllib (there are none)")),
    ("mtllib m.mtl", "usemtl", "newmtl m\nKd 1 0 0\n", White, Seq("'usemtl' without a name")),
    ("mtllib m.mtl", "usemtl m", "newmtl m\nKd 1 0 0\nmap_Kd\nmap_Ks \n", Red, Seq("m.mtl:3: 'map_Kd' without a file")),
    ("mtllib", "usemtl m", "", White, Seq("'mtllib' without a file", "material 'm'"))
  )
  for ((library, use, mtl, color, notices) <- missing)
    test(s"08: the plain colour and a notice, with --strict an error: ${notices.head}") {
      withFiles("m.obj" -> s"$library\n$square$use\nf 1/1 2/2 3/3 4/4\n", "m.mtl" -> mtl) { folder =>
        val p = draw(folder)
        assert(p.covered == 64 * 64 && p(32, 32) == color)
        assert(p.notices.length == notices.length, p.notices)
        p.notices.zip(notices).foreach { case (line, part) => assert(line.contains(part)) }
        assert(p.report.get("notices").arr.length == notices.length)
        val strict = draw(folder, "--strict")
        assert(strict.run.code == 2 && strict.picture.isEmpty && strict.report.isEmpty)
        assert(strict.run.err.length == 1 && strict.run.err.head.startsWith("error: ") && strict.run.err.head.contains(
          notices.head
        ))
      }
    }

  test("09: vertex colours with and without alpha") {
    for (alpha <- Seq("", " 1"))
      plain(s"v -1 -1 0 1 0 0$alpha\nv 1 -1 0 0 1 0$alpha\nv 1 1 0 0 0 1$alpha\nv -1 1 0 1 1 1$alpha\nf 1 2 3 4\n") {
        p =>
          def near(x: Int, y: Int, color: Int) =
            Seq(16, 8, 0).foreach(s => assert(((p(x, y) >> s & 255) - (color >> s & 255)).abs < 16, f"${p(x, y)}%06x"))
          near(0, 63, Red)
          near(63, 63, Green)
          near(63, 0, 0x0000ff)
          near(0, 0, White)
          assert(p.notices.isEmpty)
      }
    val half = "v -1 -1 0 1 1 1 0.5\nv 1 -1 0 1 1 1 0.5\nv 1 1 0 1 1 1 .5\nv -1 1 0 1 1 1 .5\nf 1 2 3 4\n"
    plain(half)(p => assert((p(32, 32) & 255) > 100 && (p(32, 32) & 255) < 150, "blended with the black background"))
  }

  test("10: a continued line, blanks after its backslash, a comment behind, the end of the file") {
    for (
      face <- Seq(
        "f 1 2 3 \\\n   4 # quad\n",
        "f 1 2 3 \\ \t\r\n 4\r\n",
        "f 1 2 3 4\\",
        "f 1 \\\n2 \\\n3 \\\n4",
        "f 1 2 3 4 \\\n\n"
      )
    )
      plain(square + face)(p => assert(p.covered == 64 * 64 && p.notices.isEmpty, face))
  }

  test("11: names in UTF-8, in Windows' code page, with several blanks, in another case") {
    for (charset <- Seq("UTF-8", "windows-1252")) withFiles() { folder =>
      val obj = folder.resolve("würfel.obj")
      write(
        obj,
        texturedSquare.replace("m.mtl", "ö ü.mtl").replace("usemtl m", "usemtl Grün"),
        Charset.forName(charset)
      )
      write(folder.resolve("ö ü.mtl"), "newmtl Grün\nKd 0 1 0\nmap_Kd té.png\n", Charset.forName(charset))
      quarters(folder.resolve("té.png"))
      val p = MeshPicture.draw(obj, MeshPicture.front: _*)
      assert(p.notices.isEmpty)
      isQuarters(p)
    }
    plain(
      texturedSquare.replace("mtllib m.mtl", "mtllib  m.mtl ").replace("usemtl m", "usemtl My  Mat.001"),
      "m.mtl" -> "newmtl  My  Mat.001 \nKd 1 0 0\n"
    ) {
      p => assert(p.notices.isEmpty && p(32, 32) == Red)
    }
    withMaterial("newmtl m\nKd 1.000001 0.5 0\n")(p => assert(p.notices.isEmpty && p(32, 32) == Orange))
    withMaterial("newmtl m\nKd 0 1 0\nmap_kd t t.png\n")(p => { assert(p.notices.isEmpty); isQuarters(p) })
  }

  test("11: names in quotes, with Windows' separators, of another machine, in another case of letters") {
    def textured(name: String) =
      withFiles("m.obj" -> texturedSquare, "m.mtl" -> s"newmtl m\nmap_Kd $name\n") { folder =>
        Files.createDirectories(folder.resolve("Tex tures"))
        quarters(folder.resolve("Tex tures/Wood.png"))
        quarters(folder.resolve("t.png"))
        val p = draw(folder)
        isQuarters(p)
        p.notices
      }
    for (name <- Seq("\"t.png\"", ".\\t.png", "Tex tures\\Wood.png", "\"Tex tures/Wood.png\""))
      assert(textured(name).isEmpty, name)
    for (name <- Seq("C:\\models\\t.png", "/home/somebody/t.png", "tex tures\\WOOD.PNG")) {
      val notices = textured(name)
      assert(notices.length == 1 && notices.head.contains("is taken for it"), notices)
    }
  }

  test("15: --texture takes the place of a picture that is missing, damaged or too large") {
    for (picture <- Seq("gone.png", "cut.png", "t.png"))
      withFiles("m.obj" -> texturedSquare, "m.mtl" -> s"newmtl m\nmap_Kd $picture\n") { folder =>
        quarters(folder.resolve("ok.png"))
        MeshFiles.picture(folder.resolve("t.png"), 8, 8)((_, _) => -1)
        Files.write(folder.resolve("cut.png"), Files.readAllBytes(folder.resolve("t.png")).take(50))
        val p = draw(folder, "--texture", folder.resolve("ok.png").toString, "--strict")
        assert(p.notices.isEmpty)
        isQuarters(p)
      }
  }

  /** The middle of what 240 x 320 pixels show of 5.5 units. */
  private val ngon = Words.split("--ortho 2.2 --eye 0,0,5 --at 0,0,0 --near 1 --far 10 --size 128x128")

  /** Pixels of 128 x 128 whose centres lie in a polygon by the even-odd rule, 2.2 units being 128 pixels. */
  private def evenOdd(p: Seq[(Double, Double)]): Int = (for (row <- 0 until 128; column <- 0 until 128) yield {
    val (x, y) = ((column + 0.5 - 64) * 2.2 / 128, (64 - row - 0.5) * 2.2 / 128)
    p.zip(p.tail :+ p.head).count { case ((ax, ay), (bx, by)) =>
      (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
    } % 2
  }).sum

  test("50: a polygon with doubled corners inwards, and a comb, are filled by the even-odd rule") {
    val doubled = Seq((-1.0, -1.0), (1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.0, -0.5), (0.0, -0.5), (-1.0, 1.0))
    val teeth = (0 until 10).flatMap(i => Seq((9 - 2 * i, -6), (9 - 2 * i, 10), (8 - 2 * i, 10), (8 - 2 * i, -6)))
    val comb = ((-10, -10) +: (10, -10) +: (10, -6) +: teeth.dropRight(1) :+ ((-10, 10))).map { case (x, y) =>
      (x / 10.0, y / 10.0)
    }
    // TriangulationTest begins at every corner of the comb
    val starts = Seq(doubled -> 1, comb -> 4)
    for ((corners, every) <- starts; first <- corners.indices by every) {
      val turned = corners.drop(first) ++ corners.take(first)
      val mesh = turned.map { case (x, y) =>
        s"v $x $y 0\n"
      }.mkString + s"f ${turned.indices.map(_ + 1).mkString(" ")}\n"
      withFiles("m.obj" -> mesh) { folder =>
        val p = MeshPicture.draw(folder.resolve("m.obj"), ngon: _*)
        val right = evenOdd(corners)
        // corners are snapped to 1/16 pixel, which moves an edge past a few centres
        assert(p.notices.isEmpty && (p.covered - right).abs <= 12, s"${p.covered} of $right")
        if (corners == doubled) assert(p.covered == 8410 && right == 8410)
      }
    }
  }

  private val cube =
    "v -1 -1 -1 1 0 0\nv 1 -1 -1 0 1 0\nv 1 1 -1 0 0 1\nv -1 1 -1 1 1 0\nv -1 -1 1 0 1 1\nv 1 -1 1 1 0 1\n" +
      "v 1 1 1 1 1 1\nv -1 1 1 .3 .3 .3\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n"

  test("60: from far away a mesh is small, and whole without a camera at any shape of picture") {
    withFiles("m.obj" -> cube) { folder =>
      val far = MeshPicture.draw(folder.resolve("m.obj"), "--eye", "50,30,80", "--size", "240x320")
      assert(far.notices.isEmpty && far.covered > 20 && far.covered < 300, far.covered)
      for (size <- Seq("64x64", "240x64", "32x320", "512x64")) {
        val p = MeshPicture.draw(folder.resolve("m.obj"), "--size", size)
        val b = p.picture.get
        def black(x: Int, y: Int) = p(x, y) == 0
        assert(p.covered > 200)
        assert((0 until b.getWidth).forall(x => black(x, 0) && black(x, b.getHeight - 1)), size)
        assert((0 until b.getHeight).forall(y => black(0, y) && black(b.getWidth - 1, y)), size)
      }
    }
  }

  test("60: an empty picture has a cause") {
    withFiles("m.obj" -> cube, "line.obj" -> "v 0 0 0\nv 1 1 1\nf 1 2 1\n") { folder =>
      def notice(file: String, arguments: String) = {
        val p = MeshPicture.draw(folder.resolve(file), Words.split(arguments): _*)
        assert(p.covered == 0 && p.notices.length == 1, p.run)
        assert(p.report.get("notices")(0)("what").str == p.notices.head.stripPrefix("notice: ").stripSuffix(" (1)"))
        p.notices.head
      }
      assert(notice("m.obj", "--eye 50,30,80 --far 50").contains("the far plane at 50.0 cuts everything away; it lies"))
      assert(notice(
        "m.obj",
        "--eye 0,0,9 --at 0,0,20 --near 1 --far 50"
      ).contains("before the near plane at 1.0 or behind the eye"))
      assert(notice("m.obj", "--eye 0,0,20 --at 40,0,0 --near 1 --far 80").contains("outside of the picture"))
      assert(notice("line.obj", "").contains("no triangle covers the centre of a pixel"))
    }
    val front = square + "f 1 2 3 4\n"
    withFiles("m.obj" -> front) { folder =>
      val n = Seq("0,0,5", "0,0,-5").flatMap(eye =>
        MeshPicture.draw(folder.resolve("m.obj"), "--cull", "back", "--eye", eye).notices
      )
      assert(n.length == 1 && n.head.contains("shows its back"))
      assert(n.head.contains("2 face away, 0 have no area"))
    }
  }

  test("pictures of other sizes and formats are resampled once, with a notice; --texture-size sets the size") {
    for ((format, name) <- Seq("png" -> "t.png", "jpg" -> "t.jpg", "bmp" -> "t.bmp"); side <- Seq(100, 256))
      withFiles("m.obj" -> texturedSquare, "m.mtl" -> s"newmtl m\nmap_Kd $name\n") { folder =>
        quarters(folder.resolve(name), side, format)
        def looks(p: MeshPicture): Unit =
          for ((at, color) <- Seq((16, 16) -> Texels(0), (48, 16) -> Texels(1), (60, 60) -> Texels(0)))
            Seq(16, 8, 0).foreach(s =>
              assert(((p(at._1, at._2) >> s & 255) - (color >> s & 255)).abs < 16, s"$name $side")
            )
        val p = draw(folder)
        looks(p)
        assert(
          p.notices.length == 1 && p.notices.head.contains(s"$name of $side x $side texels is resampled to 128 x 128")
        )
        val small = draw(folder, "--texture-size", "16")
        looks(small)
        assert(small.notices.head.contains("to 16 x 16"))
        assert(draw(folder, "--strict").run.code == 2)
        // a wrapped texture goes on at its border as before
        val shifted = draw(folder, "--wrap", "repeat")
        assert((0 until 64).forall(i => shifted(i, 32) == p(i, 32)))
      }
  }

  test("61: wrap modes as OpenGL's") {
    // s runs from -2.25 to 1.75 along 64 pixels, t from -1.5 to 2.5: 16 pixels a repeat
    val mesh =
      texturedSquare.replaceAll("(?s)vt .*usemtl", "vt -2.25 -1.5\nvt 1.75 -1.5\nvt 1.75 2.5\nvt -2.25 2.5\nusemtl")
    withFiles("m.obj" -> mesh, "m.mtl" -> "newmtl m\nmap_Kd t.png\n") { folder =>
      MeshFiles.picture(folder.resolve("t.png"), 8, 8)((x, y) => 0xff000000 | x * 32 << 16 | y * 32 << 8)
      for (
        (mode, index) <- Seq[(String, Int => Int)](
          "repeat" -> (i => Math.floorMod(i, 8)),
          "mirror" -> (i => { val m = Math.floorMod(i, 16); if (m < 8) m else 15 - m }),
          "clamp" -> (_.max(0).min(7))
        )
      ) {
        val p = draw(folder, "--wrap", mode)
        for (y <- 0 until 64; x <- 0 until 64) {
          val s = index(Math.floor(((x + 0.5) / 16 - 2.25) * 8).toInt)
          val t = index(Math.floor((2.5 - (y + 0.5) / 16) * 8).toInt)
          // red has five bits and green six
          assert(
            ((p(x, y) >> 16 & 255) + 16) / 32 == s && ((p(x, y) >> 8 & 255) + 16) / 32 == 7 - t,
            s"$mode at $x, $y"
          )
        }
        assert(p.notices.isEmpty)
      }
    }
  }
}
