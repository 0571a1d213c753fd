package frustum.scene

import java.io.ByteArrayOutputStream
import java.nio.charset.StandardCharsets.UTF_8
import java.nio.file.{Files, Path}

/** Writes .vox files by the letter of MagicaVoxel's format, as fixtures: knows nothing of what reads them. */
object VoxWriter {
  def ints(values: Int*): Array[Byte] = values.flatMap(v => (0 to 3).map(k => (v >> 8 * k).toByte)).toArray

  private def string(s: String): Array[Byte] = ints(s.getBytes(UTF_8).length) ++ s.getBytes(UTF_8)

  def dictionary(entries: (String, String)*): Array[Byte] =
    ints(entries.length) ++ entries.flatMap { case (k, v) => string(k) ++ string(v) }

  def chunk(name: String, content: Array[Byte], children: Array[Byte] = Array()): Array[Byte] =
    name.getBytes(UTF_8) ++ ints(content.length, children.length) ++ content ++ children

  /** SIZE and XYZI. */
  def model(size: (Int, Int, Int), voxels: (Int, Int, Int, Int)*): Array[Byte] =
    chunk("SIZE", ints(size._1, size._2, size._3)) ++ this.voxels(voxels: _*)

  def voxels(v: (Int, Int, Int, Int)*): Array[Byte] =
    chunk("XYZI", ints(v.length) ++ v.flatMap { case (x, y, z, c) => Seq(x, y, z, c).map(_.toByte) })

  /** A box full of one colour. */
  def full(size: (Int, Int, Int), color: Int): Array[Byte] =
    model(size, (for (x <- 0 until size._1; y <- 0 until size._2; z <- 0 until size._3) yield (x, y, z, color)): _*)

  /** Colours 0xRRGGBB of the indices from 1 on. */
  def palette(colors: Int*): Array[Byte] =
    chunk("RGBA", colors.padTo(256, 0x4b4b4b).flatMap(c => Seq(c >> 16, c >> 8, c, 255).map(_.toByte)).toArray)

  def transform(
      id: Int,
      child: Int,
      layer: Int = 0,
      hidden: Boolean = false
  )(frames: Seq[(String, String)]*): Array[Byte] =
    chunk(
      "nTRN",
      ints(id) ++ dictionary((if (hidden) Seq("_hidden" -> "1") else Nil): _*) ++ ints(
        child,
        -1,
        layer,
        frames.length
      ) ++
        frames.flatMap(dictionary(_: _*))
    )

  def group(id: Int, children: Int*): Array[Byte] =
    chunk("nGRP", ints(id) ++ dictionary() ++ ints(children.length +: children: _*))

  def shape(id: Int, models: Int*): Array[Byte] =
    chunk("nSHP", ints(id) ++ dictionary() ++ ints(models.length) ++ models.flatMap(m => ints(m) ++ dictionary()))

  def layer(id: Int, hidden: Boolean): Array[Byte] =
    chunk("LAYR", ints(id) ++ dictionary("_name" -> s"layer $id", "_hidden" -> (if (hidden) "1" else "0")) ++ ints(-1))

  def material(color: Int, properties: (String, String)*): Array[Byte] =
    chunk("MATL", ints(color) ++ dictionary(properties: _*))

  /** The editor's usual tree: a root and a group, below it a pair of nodes for each model, 2 and 3, 4 and 5, and so on.
    */
  def scene(frames: Seq[(String, String)]*): Array[Byte] = {
    val pairs = frames.zipWithIndex.flatMap { case (frame, i) =>
      transform(2 + 2 * i, 3 + 2 * i)(frame) ++ shape(3 + 2 * i, i)
    }
    transform(0, 1)(Nil) ++ group(1, frames.indices.map(2 + 2 * _): _*) ++ pairs
  }

  def file(children: Array[Byte]*): Path = {
    val out = new ByteArrayOutputStream
    out.write("VOX ".getBytes(UTF_8) ++ ints(150) ++ chunk(
      "MAIN",
      Array(),
      children.reduceOption(_ ++ _).getOrElse(Array())
    ))
    Files.write(Files.createTempFile("model", ".vox"), out.toByteArray)
  }
}
