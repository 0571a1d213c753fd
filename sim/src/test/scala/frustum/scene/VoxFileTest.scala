package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.{VoxelAssets, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.files.Notices
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Path}

/** MagicaVoxel files as worlds: places and colours of blocks against what the format says. */
class VoxFileTest extends AnyFunSuite {
  import VoxWriter._
  private val size = WorldSize(16, 16, 16)

  private case class Read(world: VoxelWorld, assets: VoxelAssets, notices: Seq[String]) {

    /** Colour at a place, RGB444, which must be that of all texels of all faces; none for air. */
    def color(x: Int, y: Int, z: Int): Option[Int] = Option.when(world(x, y, z) != 0) {
      val block = assets.table(world(x, y, z))
      val texels = for (t <- block.textures; u <- 0 until 16; v <- 0 until 16) yield assets.textures(t, u, v) >> 4
      assert(texels.distinct.length == 1, s"block ${block.name} at $x, $y, $z has several colours")
      texels.head
    }

    /** All blocks, from the low corner of the box around them. */
    def shape: Map[(Int, Int, Int), Int] = {
      val s = world.size
      val all = for (x <- 0 until s.x; y <- 0 until s.y; z <- 0 until s.z; c <- color(x, y, z)) yield (Seq(x, y, z), c)
      val low = (0 to 2).map(k => all.map(_._1(k)).min)
      all.map { case (at, c) => (at(0) - low(0), at(1) - low(1), at(2) - low(2)) -> c }.toMap
    }
  }

  private def read(file: Path, options: VoxOptions = VoxOptions(Blocks.assets), size: WorldSize = size): Read = {
    val notices = new Notices
    val (world, assets) = VoxFile.read(file, size, options, notices)
    Read(world, assets, notices.lines.map(_.stripPrefix(s"notice: $file: ")))
  }
  private def refused(file: Path, options: VoxOptions = VoxOptions(Blocks.assets)): String =
    intercept[InputError](read(file, options)).message

  private val colors = palette(0xcc2222, 0x22aa22, 0x2244cc, 0xeedd44)
  private val Seq(red, green, blue, yellow) = Seq(0xc22, 0x2a2, 0x24c, 0xed4)

  /** Each axis told from the others and its ends from each other; all sides of different length, two of them odd. */
  private val lShape = (4, 3, 5)
  private val lVoxels =
    (0 to 3).map(x => (x, 0, 0, 1)) ++ (1 to 2).map(y => (0, y, 0, 2)) ++ (1 to 4).map(z => (0, 0, z, 3)) :+ ((
      3,
      2,
      4,
      4
    ))
  private val plain = model(lShape, lVoxels: _*)
  private val seen = Map(1 -> red, 2 -> green, 3 -> blue, 4 -> yellow)

  /** Where the L comes to rest under a matrix, given by its rows: the middle of each voxel is turned about floor(size
    * / 2).
    */
  private def turned(rows: Seq[Seq[Int]]): Map[(Int, Int, Int), Int] = {
    val pivot = Seq(lShape._1 / 2, lShape._2 / 2, lShape._3 / 2)
    val all = lVoxels.map { case (x, y, z, c) =>
      val p = Seq(x + 0.5 - pivot(0), y + 0.5 - pivot(1), z + 0.5 - pivot(2))
      rows.map(row => scala.math.floor(row.zip(p).map { case (m, v) => m * v }.sum).toInt) -> seen(c)
    }
    val low = (0 to 2).map(k => all.map(_._1(k)).min)
    all.map { case (at, c) => (at(0) - low(0), at(1) - low(1), at(2) - low(2)) -> c }.toMap
  }

  test("a model stands in the middle of the world's ground, each voxel in its palette's colour") {
    val r = read(file(plain, colors))
    assert(r.color(6, 6, 0).contains(red) && r.color(9, 6, 0).contains(red) && r.color(6, 8, 0).contains(green))
    assert(r.color(6, 6, 4).contains(blue) && r.color(9, 8, 4).contains(yellow))
    assert(r.world.ids.count(_ != 0) == lVoxels.length && r.notices.isEmpty, r.notices)
  }

  test("without a palette the format's own holds: colour 1 is white, 255 nearly black") {
    val r = read(file(model((16, 16, 16), (0, 0, 0, 1), (15, 15, 15, 255))))
    assert(r.color(0, 0, 0).contains(0xfff) && r.color(15, 15, 15).contains(0x111))
  }

  test("rotations: quarter turns about z as the editor writes them, 17 and 33") {
    // Row 1 of 17 is -y, row 2 x: what pointed along +x points along +y. 33 is the turn back.
    assert(read(file(plain, scene(Seq("_r" -> "17", "_t" -> "0 0 5")), colors)).shape ==
      turned(Seq(Seq(0, -1, 0), Seq(1, 0, 0), Seq(0, 0, 1))))
    assert(read(file(plain, scene(Seq("_r" -> "33", "_t" -> "0 0 5")), colors)).shape ==
      turned(Seq(Seq(0, 1, 0), Seq(-1, 0, 0), Seq(0, 0, 1))))
  }

  test("rotations: the example of the format's description") {
    val packed = 1 << 0 | 2 << 2 | 0 << 4 | 1 << 5 | 1 << 6
    assert(read(file(plain, scene(Seq("_r" -> packed.toString)), colors)).shape ==
      turned(Seq(Seq(0, 1, 0), Seq(0, 0, -1), Seq(-1, 0, 0))))
  }

  test("rotations: all 24 and their 24 mirrors, placed by the matrix") {
    val all = for (order <- Seq(0, 1, 2).permutations.toSeq; signs <- 0 until 8) yield {
      val packed = order(0) | order(1) << 2 | signs << 4
      val rows = order.zipWithIndex.map { case (column, row) =>
        Seq.tabulate(3)(k => if (k != column) 0 else if ((signs >> row & 1) == 1) -1 else 1)
      }
      assert(read(file(plain, scene(Seq("_r" -> packed.toString)), colors)).shape == turned(rows), s"_r $packed")
      turned(rows)
    }
    assert(all.distinct.length == 48)
  }

  test("odd sizes turn about the corner of voxel floor(size / 2): a half turn moves the middle by one voxel") {
    // The voxel at 1 of 3 reaches from 0 to 1 about the pivot; turned by 180 degrees from -1 to 0.
    val bar = full((3, 1, 1), 1)
    val half = Seq("_r" -> (0 | 1 << 2 | 1 << 4 | 1 << 5).toString)
    val mark = full((1, 1, 1), 2)
    val r = read(file(bar, mark, scene(half, Seq("_t" -> "-3 0 0")), colors)).shape
    // The mark is at -3, at y 0; the bar at -2 to 0, at y -1.
    assert(r == Map((0, 1, 0) -> green, (1, 0, 0) -> red, (2, 0, 0) -> red, (3, 0, 0) -> red))
  }

  test("two models, and two instances of one, 8 apart") {
    val (left, right) = (Seq("_t" -> "-4 0 1"), Seq("_t" -> "4 0 1"))
    val two = read(file(full((3, 3, 3), 1), full((3, 3, 3), 2), scene(left, right), colors)).shape
    assert(two.size == 54 && two((0, 0, 0)) == red && two((2, 2, 2)) == red && two((8, 0, 0)) == green && two((
      10,
      2,
      2
    )) == green)
    val twice = transform(0, 1)(Nil) ++ group(1, 2, 4) ++ transform(2, 3)(left) ++ shape(3, 0) ++ transform(
      4,
      5
    )(right) ++ shape(5, 0)
    val same = read(file(full((3, 3, 3), 1), twice, colors)).shape
    assert(same == two.map { case (at, _) => at -> red })
  }

  test("groups within groups: the inner transform acts first") {
    val turn = Seq("_r" -> "17", "_t" -> "1 2 3")
    val nodes = transform(0, 1)(Nil) ++ group(1, 2, 6) ++ transform(2, 3)(turn) ++ group(3, 4) ++
      transform(4, 5)(Seq("_t" -> "5 0 0")) ++ shape(5, 0) ++ transform(6, 7)(Seq("_t" -> "0 0 0")) ++ shape(7, 1)
    // The inner one puts the voxel at (5, 0, 0); its middle (5.5, 0.5, 0.5) turns to (-0.5, 5.5, 0.5), then moves by
    // (1, 2, 3).
    val r = read(file(full((1, 1, 1), 1), full((1, 1, 1), 2), nodes, colors)).shape
    assert(r == Map((0, 7, 3) -> red, (0, 0, 0) -> green))
  }

  test("where models overlap the later one is seen") {
    val r = read(file(full((3, 3, 3), 1), full((1, 1, 1), 2), scene(Nil, Nil), colors)).shape
    assert(r((1, 1, 1)) == green && r.values.count(_ == red) == 26)
  }

  for (
    (what, nodes) <- Seq(
      "a hidden node" -> (transform(2, 3, hidden = true)(Nil) ++ shape(3, 0)),
      "a hidden layer" -> (transform(2, 3, layer = 4)(Nil) ++ shape(3, 0) ++ layer(4, hidden = true) ++ layer(
        0,
        hidden = false
      )),
      "a hidden group" -> (transform(2, 6, hidden = true)(Nil) ++ group(6, 7) ++ transform(7, 3)(Nil) ++ shape(3, 0))
    )
  ) test(s"$what is left out, with a notice") {
    val tree = transform(0, 1)(Nil) ++ group(1, 2, 4) ++ nodes ++ transform(4, 5)(Nil) ++ shape(5, 1)
    val r = read(file(full((3, 3, 3), 1), full((1, 1, 1), 2), tree, colors))
    assert(r.shape == Map((0, 0, 0) -> green) && r.notices == Seq("hidden models left out (1)"), r.notices)
  }

  test("colour index 0 is empty") {
    val r = read(file(model((2, 1, 1), (0, 0, 0, 0), (1, 0, 0, 1)), colors))
    assert(r.shape == Map((0, 0, 0) -> red))
    assert(refused(file(model((2, 1, 1), (0, 0, 0, 0)), colors)).contains("no voxels"))
  }

  test("IMAP orders the editor's palette and changes no colour") {
    val r = read(file(plain, colors, chunk("IMAP", Array.tabulate(256)(i => (255 - i).toByte))))
    assert(r.shape == turned(Seq(Seq(1, 0, 0), Seq(0, 1, 0), Seq(0, 0, 1))))
  }

  test("glass is a see-through block without faces within, and solid on request") {
    val glass = file(full((3, 3, 3), 1), palette(0x78c8ff), material(1, "_type" -> "_glass", "_trans" -> "0.6"))
    val r = read(glass)
    val block = r.assets.table(r.world(7, 7, 0))
    assert(!block.opaque && block.joins && r.color(7, 7, 0).contains(0x7cf))
    assert((r.assets.textures(block.textures.head, 3, 3) & 15) == 6) // 0.4 of 15
    val solid = read(glass, VoxOptions(Blocks.assets, opaque = true))
    assert(solid.assets.table(solid.world(7, 7, 0)).opaque && solid.color(7, 7, 0).contains(0x7cf))
  }

  test("glass of files before the scene graph, MATT") {
    def weight(w: Float) = java.lang.Float.floatToIntBits(w)
    val r = read(file(full((1, 1, 1), 1), colors, chunk("MATT", ints(1, 2, weight(0.2f), 0))))
    val block = r.assets.table(r.world(7, 7, 0))
    assert(!block.opaque && (r.assets.textures(block.textures.head, 0, 0) & 15) == 12)
  }

  test("other materials are drawn in their colour alone, with a notice") {
    val r = read(file(
      plain,
      colors,
      material(1, "_type" -> "_emit"),
      material(2, "_type" -> "_metal"),
      material(9, "_type" -> "_metal")
    ))
    assert(r.notices == Seq("colours whose material is neither diffuse nor glass, drawn without it (2)"), r.notices)
  }

  test("white, greys, greens, browns: each block has one colour on all sides") {
    val wanted = Seq(0xffffff, 0xe6e6e6, 0x808080, 0x28a028, 0x78c850, 0xc8aa78, 0x785028, 0xff96b4)
    val cubes = model((16, 1, 1), wanted.indices.map(i => (2 * i, 0, 0, i + 1)): _*)
    val r = read(file(cubes, palette(wanted: _*)))
    val found = wanted.indices.map(i => r.color(2 * i, 7, 0).get)
    assert(found == wanted.map(rgb =>
      Seq(16, 8, 0).map(at => ((rgb >> at & 255) / 17.0).round.toInt).reduce(_ << 4 | _)
    ))
    assert(r.notices.isEmpty)
  }

  test("a texture is taken where all faces have the colour") {
    def top(name: String) = {
      val t = Blocks.table(Blocks.id(name)).textures(5)
      val texels = for (u <- 0 until 16; v <- 0 until 16) yield Blocks.assets.textures(t, u, v)
      Seq(12, 8, 4).map(at => (texels.map(_ >> at & 15).sum * 17.0 / 256).round.toInt).reduce(_ << 8 | _)
    }
    // `grass` has its green on the top alone.
    val r = read(file(model((2, 1, 1), (0, 0, 0, 1), (1, 0, 0, 2)), palette(top("basalt"), top("grass"))))
    assert(r.assets.table(r.world(7, 7, 0)).name == "basalt" && r.assets.table(r.world(8, 7, 0)).name != "grass")
    assert(r.color(8, 7, 0).isDefined)
  }

  private val many = (0 until 40).map(i => i * 6 << 16 | 0x8800 | 255 - i * 6)
  private val stack =
    model((40, 1, 1), many.indices.flatMap(i => Seq.fill(1 + (if (i < 20) 1 else 0))((i, 0, 0, i + 1))): _*)

  test("more colours than blocks: the nearest one, with a notice that counts") {
    val spread = (0 until 64).map(i => (i & 3) * 0x55 << 16 | (i >> 2 & 3) * 0x55 << 8 | (i >> 4) * 0x55)
    val r = read(file(model((16, 4, 1), spread.indices.map(i => (i % 16, i / 16, 0, i + 1)): _*), palette(spread: _*)))
    assert(r.assets.table.blocks.length == 31)
    assert(r.notices == Seq("colours of 64 shown in that of the nearest of 31 blocks (33)"), r.notices)
  }

  test("frequent colours have blocks of their own before rare ones; what four bits hold alike is one colour") {
    val wide = read(file(stack, palette(many: _*)), size = WorldSize(64, 4, 4))
    assert(wide.assets.table.blocks.length <= 31 && wide.notices.isEmpty)
  }

  test("a table of the user's stays whole, plain blocks fill its room") {
    val r = read(file(plain, colors), VoxOptions(Blocks.assets, keep = true))
    assert(r.assets.table.blocks.take(24) == Blocks.table.blocks && r.notices.length == 1)
    assert(r.notices.head.contains("nearest of 24 blocks (4)")) // the 32 textures are all in use
    val few = VoxelAssets(
      frustum.contract.voxel.BlockTable(Blocks.table.blocks.take(2)),
      frustum.contract.voxel.VoxelTextures(
        Blocks.assets.textures.indices.take(3),
        Blocks.assets.textures.palettes.take(3)
      )
    )
    val grown = read(file(plain, colors), VoxOptions(few, keep = true))
    assert(grown.assets.table.blocks.length == 6 && grown.notices.isEmpty && grown.shape.values.toSet == Set(
      red,
      green,
      blue,
      yellow
    ))
  }

  test("a table that must not grow: the nearest of all faces") {
    val r = read(
      file(plain, palette(0x2244cc, 0xcc3333, 0xf0f0f0, 0x55a040)),
      VoxOptions(Blocks.assets, keep = true, grow = false)
    )
    def name(x: Int, y: Int, z: Int) = r.assets.table(r.world(x, y, z)).name
    assert(name(6, 6, 0) == "blue wool" && name(6, 7, 0) == "red wool" && r.assets == Blocks.assets)
    assert(!Set("snow", "grass").contains(name(6, 6, 4)) && !Set("snow", "grass").contains(name(9, 8, 4)))
  }

  test("a scene larger than the world: what fits, and --crop takes a part of it") {
    val long = file(full((40, 2, 2), 1), colors)
    val message = refused(long)
    assert(message.startsWith(long.toString))
    Seq("40x2x2", "16x16x16", "--world-size 64x4x4", "--crop x,y,z").foreach(w => assert(message.contains(w), message))
    assert(refused(file(full((200, 2, 2), 1), colors)).contains("no world is larger than 128x128x128"))
    val r = read(long, VoxOptions(Blocks.assets, crop = Some((30, 1, 0))))
    // 10 x 1 x 2 voxels are left, in the middle.
    assert(r.world.ids.count(_ != 0) == 20 && r.color(3, 7, 0).contains(red) && r.color(12, 7, 1).contains(red))
    assert(r.notices == Seq("voxels outside of the part of 10x1x2 that --crop takes (140)"), r.notices)
    assert(refused(long, VoxOptions(Blocks.assets, crop = Some((40, 0, 0)))).startsWith("--crop 40,0,0: "))
    val holes = file(model((40, 1, 1), (0, 0, 0, 1)), colors)
    assert(refused(holes, VoxOptions(Blocks.assets, crop = Some((1, 0, 0)))).contains("no voxel in the part"))
  }

  test("a box larger than the world whose voxels fit") {
    val r = read(file(model((40, 40, 40), (30, 30, 30, 1), (31, 30, 30, 2)), colors))
    assert(r.color(7, 7, 0).contains(red) && r.color(8, 7, 0).contains(green))
  }

  test("frames after the first, models of an animation, unused models, empty models, unknown chunks: a notice each") {
    val frames = transform(0, 1)(Nil) ++ group(1, 2) ++ transform(2, 3)(
      Seq("_f" -> "0"),
      Seq("_f" -> "5", "_t" -> "9 9 9")
    ) ++ shape(3, 0, 1)
    val r = read(file(plain, full((1, 1, 1), 1), frames, colors, chunk("XYZZ", Array())))
    assert(r.shape == turned(Seq(Seq(1, 0, 0), Seq(0, 1, 0), Seq(0, 0, 1))))
    assert(
      r.notices == Seq(
        "frames of an animation after the first left out (2)",
        "chunks 'XYZZ' are not known and left out (1)",
        "models that the scene does not show left out (1)"
      ),
      r.notices
    )
    assert(read(file(
      plain,
      full((1, 1, 1), 1),
      colors
    )).notices == Seq("models after the first, which are an animation's, left out (1)"))
    assert(read(file(plain, model((1, 1, 1)), scene(Nil, Nil), colors)).notices == Seq("models without voxels (1)"))
  }

  private val voxel = full((1, 1, 1), 1)
  for (
    (what, file, words) <- Seq(
      (
        "a model larger than the world",
        file(model((17, 8, 8), (0, 0, 0, 1), (16, 0, 0, 1))),
        Seq("17x1x1 of its 17x8x8", "--world-size 32x4x4")
      ),
      ("a voxel outside of its model", file(model((2, 2, 2), (2, 0, 0, 1))), Seq("(2, 0, 0)")),
      ("fewer voxels than told", file(chunk("SIZE", ints(2, 2, 2)), chunk("XYZI", ints(5))), Seq("XYZI", "24")),
      ("a model without extent", file(model((0, -1, 2))), Seq("0x-1x2")),
      ("no model", file(chunk("PACK", ints(1))), Seq("no voxels", "SIZE and XYZI")),
      ("a model without voxels", file(model((3, 3, 3))), Seq("no voxels", "empty")),
      ("a size without voxels", file(chunk("SIZE", ints(3, 3, 3))), Seq("XYZI")),
      ("voxels without a size", file(voxels((0, 0, 0, 1))), Seq("XYZI without a SIZE")),
      ("all hidden", file(voxel, transform(0, 1, hidden = true)(Nil), shape(1, 0)), Seq("hidden")),
      ("a node that is not there", file(voxel, transform(0, 7)(Nil)), Seq("node 0 names node 7")),
      ("no root", file(voxel, transform(3, 4)(Nil), shape(4, 0)), Seq("node 0")),
      ("a node below itself", file(voxel, transform(0, 1)(Nil), group(1, 0)), Seq("node 0 lies below itself")),
      ("a model that is not there", file(voxel, transform(0, 1)(Nil), shape(1, 3)), Seq("node 1 shows model 3", "1")),
      ("a node twice", file(voxel, transform(0, 1)(Nil), transform(0, 1)(Nil)), Seq("two nodes 0")),
      ("no rotation", file(voxel, transform(0, 1)(Seq("_r" -> "0")), shape(1, 0)), Seq("'0' is no rotation")),
      ("no translation", file(voxel, transform(0, 1)(Seq("_t" -> "1 2")), shape(1, 0)), Seq("'1 2'")),
      (
        "a translation beyond measure",
        file(voxel, transform(0, 1)(Seq("_t" -> "0 0 2000000000")), shape(1, 0)),
        Seq("2000000000")
      ),
      ("a node without frames", file(voxel, transform(0, 1)(), shape(1, 0)), Seq("without frames")),
      ("a dictionary cut short", file(voxel, chunk("nTRN", ints(0, 1, 2) ++ "_n".getBytes ++ ints(100))), Seq("nTRN")),
      ("a negative count", file(voxel, chunk("nGRP", ints(0, 0, -4))), Seq("-4 children")),
      (
        "paths without end",
        file((voxel +: (0 until 40).map(i => group(i, i + 1, i + 1)) :+ shape(40, 0)): _*),
        Seq("65536 nodes")
      )
    )
  ) test(s"refused: $what") {
    val message = refused(file)
    assert(message.startsWith(file.toString) && !message.contains('\n'), message)
    words.foreach(w => assert(message.contains(w), message))
  }

  test("a file cut short at any byte, or with any byte changed, is read or refused in one line (seed 7)") {
    val bytes = Files.readAllBytes(file(
      plain,
      scene(Seq("_r" -> "17")),
      layer(0, hidden = false),
      material(1, "_type" -> "_glass"),
      colors
    ))
    val random = new scala.util.Random(7)
    val path = Files.createTempFile("fuzz", ".vox")
    val start = bytes.length - 1024 - 300 // all but the palette
    val broken = (8 until bytes.length by 7).map(bytes.take) ++
      Seq.fill(400)(bytes.updated(random.nextInt(start), random.nextInt(256).toByte))
    for (b <- broken) {
      Files.write(path, b)
      try read(path)
      catch { case InputError(message) => assert(!message.contains('\n')) }
    }
  }
}
