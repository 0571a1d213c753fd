package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.WorldSize
import frustum.demos.voxel.Blocks
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import java.nio.{ByteBuffer, ByteOrder}

/** MagicaVoxel files as worlds. */
class VoxFileTest extends AnyFunSuite {
  private val size = WorldSize(8, 8, 8)

  private def chunk(name: String, content: Array[Byte], children: Array[Byte] = Array()): Array[Byte] =
    name.getBytes ++ ints(content.length, children.length) ++ content ++ children
  private def ints(values: Int*): Array[Byte] = {
    val buffer = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN)
    values.foreach(buffer.putInt)
    buffer.array
  }
  private def vox(children: Array[Byte]*): java.nio.file.Path =
    Files.write(
      Files.createTempFile("model", ".vox"),
      "VOX ".getBytes ++ ints(150) ++ chunk("MAIN", Array(), children.reduce(_ ++ _))
    )
  private def voxels(v: (Int, Int, Int, Int)*) =
    chunk("XYZI", ints(v.length) ++ v.flatMap { case (x, y, z, c) => Seq(x, y, z, c).map(_.toByte) })

  test("voxels stand in the middle of the ground, as blocks of the nearest colour") {
    val snow = 0xf6fafc
    val colors = chunk(
      "RGBA",
      ints((Seq(0x0000ff, snow) ++ Seq.fill(254)(0)).map { rgb =>
        0xff << 24 | (rgb & 255) << 16 | rgb & 0xff00 | rgb >> 16 & 255
      }: _*)
    )
    val file = vox(chunk("SIZE", ints(2, 4, 3)), voxels((0, 0, 0, 1), (1, 3, 2, 2)), colors)
    val world = VoxFile.read(file, size, Blocks.assets)
    assert(world(3, 2, 0) == Blocks.id("blue wool"))
    assert(world(4, 5, 2) == Blocks.id("snow"))
    assert(world.ids.count(_ != 0) == 2)
  }

  test("without a palette the format's own holds: colour 1 is white, 255 nearly black") {
    val world = VoxFile.read(
      vox(chunk("SIZE", ints(8, 8, 8)), voxels((0, 0, 0, 1), (7, 7, 7, 255))),
      size,
      Blocks.assets
    )
    assert(world(0, 0, 0) == Blocks.id("snow") && world(7, 7, 7) == Blocks.id("basalt"))
  }

  for (
    (what, file, words) <- Seq(
      (
        "a model larger than the world",
        vox(chunk("SIZE", ints(9, 8, 8)), voxels()),
        Seq("9x8x8", "--world-size")
      ),
      (
        "two models",
        vox(chunk("SIZE", ints(1, 1, 1)), voxels(), chunk("SIZE", ints(1, 1, 1)), voxels()),
        Seq("2 models")
      ),
      (
        "a voxel outside of its model",
        vox(chunk("SIZE", ints(2, 2, 2)), voxels((2, 0, 0, 1))),
        Seq("(2, 0, 0)")
      ),
      (
        "fewer voxels than told",
        vox(chunk("SIZE", ints(2, 2, 2)), chunk("XYZI", ints(5))),
        Seq("XYZI", "24")
      ),
      ("a model without extent", vox(chunk("SIZE", ints(0, -1, 2)), voxels()), Seq("0x-1x2")),
      ("no model", vox(chunk("PACK", ints(1))), Seq("0 models"))
    )
  ) test(s"refused: $what") {
    val message = intercept[InputError](VoxFile.read(file, size, Blocks.assets)).message
    assert(message.startsWith(file.toString))
    words.foreach(w => assert(message.contains(w), message))
  }
}
